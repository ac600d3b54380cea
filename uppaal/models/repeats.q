/* E1 holds: all attempts can be used. */
E<> Police1.GivenUp && Police2.GivenUp
