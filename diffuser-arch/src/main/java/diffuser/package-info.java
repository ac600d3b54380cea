/**
 * Gives a Jason agent a body: a board on a serial port, whose sensors are beliefs, whose actuators are actions,
 * and whose radio carries messages to agents on other devices.
 *
 * <p>{@link diffuser.Diffuser} is the architecture; the internal actions that go with it are in
 * {@code jason.stdlib}, where Jason looks for those that begin with a dot.
 */
package diffuser;
