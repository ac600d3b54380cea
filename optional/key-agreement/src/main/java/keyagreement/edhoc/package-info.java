/**
 * EDHOC (RFC 9528) with method 3 and cipher suite 2: two parties with static Diffie-Hellman keys agree on a secret in
 * three messages. No I/O; it knows nothing of boards, and of certificates only what
 * {@link keyagreement.edhoc.Party} says.
 */
package keyagreement.edhoc;
