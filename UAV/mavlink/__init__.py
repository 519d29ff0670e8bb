"""door under work"""
