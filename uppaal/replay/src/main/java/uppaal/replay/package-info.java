/** What boards did, by the emulator's trace, replayed in the model {@code observed.xml}. */
package uppaal.replay;
