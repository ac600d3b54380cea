#include "Aes128Core.h"

#if JAVINO_AES_IN_ASSEMBLY && JAVINO_LARGE

; AES-128 for AVR: the functions of Aes128Core.h.
;
; Time. No branch and no address but that of a table depends on key or data, and LPM takes three cycles at every
; address: the number of cycles is always the same. It is held by test/cycles.
;
; Method. The state stays in registers. Round key bytes are loaded right into the low byte of Z, where the state byte
; is added and the S-box looked up: AddRoundKey and SubBytes are one step of six cycles. MixColumns needs three doublings
; a column instead of four, and takes them from a second table: that costs no more than shifting and masking, but leaves
; the operand as it was, which saves the copies. ShiftRows and the places where MixColumns leaves bytes are names of
; registers only, and cost nothing. Two rounds are written out, and bring all bytes back to where they were: in the odd
; ones each lookup writes to the register that the lookup before has freed.
;
; Flash. Each table is aligned to 256 bytes, so that a byte is its own address in the table that the high byte of Z
; selects. LPM reads the lowest 64 KiB, whatever RAMPZ holds. The linker places .progmem.gcc, which is meant for such
; tables, right behind the vectors, where aligning costs least. test/cycles looks whether it did.
;
; Round keys. All of them are computed ahead. Those of even rounds lie in the order of their bytes; those of odd rounds in
; the order in which bytes follow each other from register to register, see in_turn.

#define XL r26
#define XH r27
#define YL r28
#define YH r29
#define ZL r30
#define ZH r31

  .section .progmem.gcc_javino_aes128, "a", @progbits
  .balign 256
s_box:
#define ROW(...) .byte __VA_ARGS__
#include "Aes128SBox.inc"
doubled:                                ; times x in GF(2^8), FIPS 197 section 4.2.1
  .set value, 0
  .rept 256
  .byte (value << 1 ^ (value >> 7) * 0x1b) & 0xff
  .set value, value + 1
  .endr

; Registers that a function must preserve, of those used here.

  .macro push_saved
  .irp register, 10, 11, 12, 13, 14, 15, 16, 17
  push r\register
  .endr
  .endm

  .macro pop_saved
  .irp register, 17, 16, 15, 14, 13, 12, 11, 10
  pop r\register
  .endr
  .endm

; byte0 to byte15 are the numbers of the registers of a state or round key: at first r1, and r10 to r24.

  .macro place_bytes
  .set byte0, 1
  .irp index, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
  .set byte\index, 9 + \index
  .endr
  .endm

  .macro rename_bytes
  .irp index, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
  .set byte\index, new\index
  .endr
  .endm

  .macro in_order do
  .irp index, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
  \do byte\index
  .endr
  .endm

  .macro in_turn do
  .irp index, 1, 5, 9, 13, 11, 15, 3, 7, 8, 6, 10, 14, 2, 12, 0, 4
  \do byte\index, new\index
  .endr
  .endm

  .macro in_order_shifted do            ; what ShiftRows brings to byte 0, 1, ...
  .irp index, 0, 5, 10, 15, 4, 9, 14, 3, 8, 13, 2, 7, 12, 1, 6, 11
  \do byte\index
  .endr
  .endm

; ---------------------------------------------------------------------------------------------------------------------
; void javino_aes128_encrypt(const uint8_t *roundKeys, const uint8_t *in, uint8_t *out)
; void javino_aes128_chain(const uint8_t *roundKeys, const uint8_t *in, uint8_t *onto, const uint8_t *stop, uint8_t back)
;                          r25:r24                   r23:r22            r21:r20        r19:r18              r16
;
; X: next byte of the round keys. Y: out or onto. T: whether it is a chain; then r9:r8: stop, r7: back.
; r25: pairs of rounds left.

  .macro load_byte byte
  ld \byte, Z+
  .endm

  .macro add_key_and_substitute byte, new
  ld ZL, X+
  eor ZL, \byte
  lpm \byte, Z
  .endm

  .macro add_key byte
  ld ZL, X+
  eor \byte, ZL
  .endm

  .macro store_byte byte
  st Y+, \byte
  .endm

  .macro add_stored_byte byte
  ld ZL, Y
  eor \byte, ZL
  st Y+, \byte
  .endm

; With a b c d the column, and 2 the doubling:
;   2a + 3b +  c +  d = (b + (c + d)) + 2(a + b)            = first
;    a + 2b + 3c +  d = first + (a + b) + 2(a + c)
;    a +  b + 2c + 3d = (d + (a + b)) + 2(c + d)            = third
;   3a +  b +  c + 2d = third + (c + d) + 2(a + c)
; The results are left in b, a, d, c in this order. 23 cycles.

  .macro mix_all_but_second a, b, c, d
  mov ZL, \a
  eor ZL, \c
  lpm scratch, Z                        ; 2(a + c)
  eor \a, \b                            ; a + b
  eor \c, \d                            ; c + d
  eor \b, \c
  eor \d, \a
  mov ZL, \a
  lpm ZL, Z
  eor \b, ZL                            ; first
  mov ZL, \c
  lpm ZL, Z
  eor \d, ZL                            ; third
  eor \c, scratch
  eor \c, \d                            ; fourth
  .endm

  .macro mix_column a, b, c, d
  mix_all_but_second \a, \b, \c, \d
  eor \a, scratch
  eor \a, \b                            ; second
  .endm

; The same, but second is left in scratch, and a is scratch from then on.

  .macro mix_column_to_scratch a, b, c, d
  mix_all_but_second \a, \b, \c, \d
  eor scratch, \a
  eor scratch, \b                       ; second
  .endm

; Each mixes a column whose rows 0 to 3 are bytes a b c d, and notes the places of the new bytes v w x y.

  .macro mix_from_row_0 v, w, x, y, a, b, c, d
  mix_column byte\a, byte\b, byte\c, byte\d
  .set new\v, byte\b
  .set new\w, byte\a
  .set new\x, byte\d
  .set new\y, byte\c
  .endm

  .macro mix_from_row_0_to_scratch v, w, x, y, a, b, c, d
  mix_column_to_scratch byte\a, byte\b, byte\c, byte\d
  .set new\v, byte\b
  .set new\w, scratch
  .set new\x, byte\d
  .set new\y, byte\c
  .set scratch, byte\a
  .endm

  .macro mix_from_row_1_to_scratch v, w, x, y, a, b, c, d
  mix_column_to_scratch byte\b, byte\c, byte\d, byte\a
  .set new\w, byte\c
  .set new\x, scratch
  .set new\y, byte\a
  .set new\v, byte\d
  .set scratch, byte\b
  .endm

; ShiftRows is in the choice of the bytes: row r comes from r columns further right.

  .macro shift_and_mix third_column, fourth_column
  ldi ZH, hi8(doubled)
  mix_from_row_0   0,  1,  2,  3,   0,  5, 10, 15
  mix_from_row_0   4,  5,  6,  7,   4,  9, 14,  3
  \third_column    8,  9, 10, 11,   8, 13,  2,  7
  \fourth_column  12, 13, 14, 15,  12,  1,  6, 11
  rename_bytes
  .endm

  .macro even_round
  ldi ZH, hi8(s_box)
  in_order add_key_and_substitute
  shift_and_mix mix_from_row_0, mix_from_row_0
  .endm

  .macro add_key_substitute_and_move byte, new
  ld ZL, X+
  eor ZL, \byte
  lpm scratch, Z
  .set \new, scratch
  .set scratch, \byte
  .endm

  .macro odd_round
  ldi ZH, hi8(s_box)
  in_turn add_key_substitute_and_move
  rename_bytes
  shift_and_mix mix_from_row_0_to_scratch, mix_from_row_1_to_scratch
  .endm

  .macro check_places
  .if scratch != 0 || byte0 != 1
  .error "two rounds do not bring scratch and byte 0 back to where they were"
  .endif
  .irp index, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
  .if byte\index != 9 + \index
  .error "two rounds do not bring all bytes back to where they were"
  .endif
  .endr
  .endm

  .section .text.javino_aes128_encrypt, "ax", @progbits
  .global javino_aes128_encrypt
  .type javino_aes128_encrypt, @function
  .global javino_aes128_chain
  .type javino_aes128_chain, @function

javino_aes128_chain:
  push r7
  push r8
  push r9
  mov r7, r16
  movw r8, r18
  set
  rcall encrypt
  pop r9
  pop r8
  pop r7
  ret

javino_aes128_encrypt:
  clt
encrypt:
  push_saved
  push YL
  push YH
  movw XL, r24
  movw ZL, r22
  movw YL, r20
load:
  .set scratch, 0
  place_bytes
  in_order load_byte
  ldi r25, 5
  rjmp even_part

; The assembler goes through the rounds in the order in which they run, to know where the bytes are. In the program, the
; odd round comes before the even one, which saves a jump in every pair.

  .subsection 1
even_part:
  even_round
  dec r25
  breq last_round
  rjmp odd_part
last_round:
  ldi ZH, hi8(s_box)
  in_turn add_key_and_substitute
  in_order_shifted add_key
  brts add_stored
  in_order_shifted store_byte
restore:
  pop YH
  pop YL
  pop_saved
  clr r1
  ret
add_stored:
  in_order_shifted add_stored_byte
  sub YL, r7
  sbc YH, r25                         ; 0 by now
  cp YL, r8
  cpc YH, r9
  brne next_of_chain
  rjmp restore
next_of_chain:
  movw ZL, YL
  sbiw ZL, 16
  subi XL, 11 * 16                      ; back to the first round key
  sbci XH, 0
  rjmp load


  .subsection 0
odd_part:
  odd_round
  check_places

; ---------------------------------------------------------------------------------------------------------------------
; void javino_aes128_expand(uint8_t *roundKeys, const uint8_t *key)
;                           r25:r24             r23:r22

  .section .text.javino_aes128_expand, "ax", @progbits
  .global javino_aes128_expand
  .type javino_aes128_expand, @function

; The latest round key stays in registers. X: next byte of the round keys. Z: key, then table. r25: round constant.

  .macro copy_byte byte
  ld \byte, Z+
  st X+, \byte
  .endm

  .macro add_substituted byte, from
  mov ZL, \from
  lpm ZL, Z
  eor \byte, ZL
  .endm

  .macro add_word v, w, x, y, a, b, c, d
  eor byte\v, byte\a
  eor byte\w, byte\b
  eor byte\x, byte\c
  eor byte\y, byte\d
  .endm

  .macro append_round_key store
  add_substituted byte0, byte13
  add_substituted byte1, byte14
  add_substituted byte2, byte15
  add_substituted byte3, byte12
  eor byte0, r25
  lsl r25
  add_word  4,  5,  6,  7,   0,  1,  2,  3
  add_word  8,  9, 10, 11,   4,  5,  6,  7
  add_word 12, 13, 14, 15,   8,  9, 10, 11
  \store append_byte
  .endm

  .macro append_byte byte, new
  st X+, \byte
  .endm

javino_aes128_expand:
  push_saved
  movw XL, r24
  movw ZL, r22
  place_bytes
  in_order copy_byte
  ldi ZH, hi8(s_box)
  ldi r25, 0x01
two_round_keys:
  append_round_key in_turn
  append_round_key in_order
  brcs after_0x80
  cpi r25, 0x6c                         ; what would come after 0x36, the last one
  breq expanded
  rjmp two_round_keys
after_0x80:
  ldi r25, 0x1b
  rjmp two_round_keys
expanded:
  pop_saved
  clr r1
  ret

  .size javino_aes128_expand, . - javino_aes128_expand

#endif
