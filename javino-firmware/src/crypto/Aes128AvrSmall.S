#include "Aes128Core.h"

#if JAVINO_AES_IN_ASSEMBLY && !JAVINO_LARGE

; AES-128 for small AVRs: the functions of Aes128Core.h in 900 bytes of flash less than in Aes128Avr.S, whose notes on time
; and tables hold here too. A block takes two thirds more cycles.
;
; Method. The columns of the state lie in pairs of registers. What is done for each of them is done for the first one,
; four times, and each time all columns move up by one. Of the round keys there is room for one, and behind it for the
; key that each block begins with; each round computes the next.

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

; void javino_aes128_encrypt(const uint8_t *roundKeys, const uint8_t *in, uint8_t *out)
;                            r25:r24                   r23:r22            r21:r20
;
; r8 to r23: the state. X: out. Y: the round key. r24: columns left. r25: constant of the next round key. r0 to r3, Z: scratch.

  .macro double byte                    ; times x in GF(2^8), FIPS 197 section 4.2.1; ZH: 0x1b
  lsl \byte
  sbc ZL, ZL
  and ZL, ZH
  eor \byte, ZL
  .endm

  .section .text.javino_aes128_encrypt, "ax", @progbits
  .global javino_aes128_encrypt
  .type javino_aes128_encrypt, @function

javino_aes128_encrypt:
  .irp register, 2, 3, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 28, 29
  push r\register
  .endr
  movw YL, r24
  movw ZL, r22
  movw XL, r20
  ldi r24, 16
copy_key:
  ldd r0, Y + 16
  st Y+, r0
  dec r24
  brne copy_key
  sbiw YL, 16
  ldi r24, 4
load_column:
  .irp byte, 8, 9, 10, 11
  ld r\byte, Z+
  .endr
  rcall next_column
  brne load_column
  ldi r25, 0x01

next_round:
  ldi ZH, hi8(s_box)
  ldi r24, 4
substitute_column:                      ; AddRoundKey, SubBytes
  .irp byte, 8, 9, 10, 11
  ld ZL, Y+
  eor ZL, r\byte
  lpm r\byte, Z
  .endr
  rcall next_column
  brne substitute_column
  sbiw YL, 16

  .macro rotate_row a, b, c, d
  mov r0, \a
  mov \a, \b
  mov \b, \c
  mov \c, \d
  mov \d, r0
  .endm

  .macro swap_bytes a, b
  mov r0, \a
  mov \a, \b
  mov \b, r0
  .endm

  rotate_row r9, r13, r17, r21          ; ShiftRows
  swap_bytes r10, r18
  swap_bytes r14, r22
  rotate_row r23, r19, r15, r11

  .irp index, 0, 1, 2, 3                ; the next round key; r0 to r3: the word before the one that is computed
  ldd ZL, Y + 12 + ((\index + 1) & 3)
  lpm r\index, Z
  .endr
  eor r0, r25
  lsl r25
  brcc add_words
  ldi r25, 0x1b
add_words:
  ldi r24, 4
add_word:
  .irp index, 0, 1, 2, 3
  ld ZL, Y
  eor r\index, ZL
  st Y+, r\index
  .endr
  dec r24
  brne add_word
  sbiw YL, 16
  ldi r24, 4
  cpi r25, 0x6c                         ; what would come after 0x36, the last one
  breq store_column

; With a b c d the column, and 2 the doubling: 2a + 3b + c + d = a + (a + b + c + d) + 2(a + b), and so on around it.

  ldi ZH, 0x1b
mix_column:
  mov r0, r8
  eor r0, r9
  mov r1, r9
  eor r1, r10
  mov r2, r10
  eor r2, r11
  mov r3, r0
  eor r3, r2                            ; a + b + c + d
  double r0
  double r1
  double r2
  eor r0, r3
  eor r8, r0
  eor r11, r0
  eor r11, r1
  eor r11, r2
  eor r1, r3
  eor r9, r1
  eor r2, r3
  eor r10, r2
  rcall next_column
  brne mix_column
  rjmp next_round

store_column:
  .irp byte, 8, 9, 10, 11
  ld ZL, Y+
  eor r\byte, ZL
  st X+, r\byte
  .endr
  rcall next_column
  brne store_column
  .irp register, 29, 28, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 3, 2
  pop r\register
  .endr
  clr r1
  ret

; Rotates the columns, so that the second one is the first; the Z flag: whether this was done four times.

next_column:
  movw r0, r8
  movw r2, r10
  .irp register, 8, 10, 12, 14, 16, 18
  movw \register, \register + 4
  .endr
  movw r20, r0
  movw r22, r2
  dec r24
  ret

; ---------------------------------------------------------------------------------------------------------------------
; void javino_aes128_expand(uint8_t *roundKeys, const uint8_t *key)
;                           r25:r24             r23:r22

  .section .text.javino_aes128_expand, "ax", @progbits
  .global javino_aes128_expand
  .type javino_aes128_expand, @function

javino_aes128_expand:
  movw XL, r24
  adiw XL, 16
  movw ZL, r22
  ldi r25, 16
copy_byte_of_key:
  ld r0, Z+
  st X+, r0
  dec r25
  brne copy_byte_of_key
  ret

  .size javino_aes128_expand, . - javino_aes128_expand

#endif
