#pragma once
// WebAssembly has no pages to give advice on.
