/** Hosts that have never met agree on a fresh key by radio, by certificates of one authority. */
package keyagreement;
