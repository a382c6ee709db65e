// The headers of a precompiled header need a source to belong to.
