namespace first_contact {}
