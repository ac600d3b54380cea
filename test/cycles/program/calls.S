; Calls of the two assembly functions with the markers right before and behind the call, so that what is measured is
; CALL, function and RET. The arguments are those of the function.

#include <avr/io.h>

#include "crypto/Aes128Core.h"

  .macro measured_call name, function
  .global measured_\name
measured_\name:
  sts _SFR_MEM_ADDR(TWBR), r24
  call \function
  sts _SFR_MEM_ADDR(TWBR), r1
  ret
  .endm

  measured_call expand, javino_aes128_expand
  measured_call encrypt, javino_aes128_encrypt
