/* O13 holds: if others use the air for 96 ms before a repeat, the host may get it as another one. */
E<> given1 == 2
