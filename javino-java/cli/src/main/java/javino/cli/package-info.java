/** The {@code javino} command: one class a subcommand; exit code 0 done, 1 failed, 2 wrong usage. */
package javino.cli;
