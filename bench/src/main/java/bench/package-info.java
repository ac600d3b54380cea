/** What Javino costs and how fast it is: one class a subject, one table for all. */
package bench;
