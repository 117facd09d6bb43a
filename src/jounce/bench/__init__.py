"""The laboratory bench: drive and belt, similitude of the prototype, choice of the spring."""
