"""The wire: bytes in, frames and bytes out. It has never heard of components."""
