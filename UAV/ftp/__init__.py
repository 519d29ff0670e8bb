"""MAVLink FTP: frames, and a server for any component."""
