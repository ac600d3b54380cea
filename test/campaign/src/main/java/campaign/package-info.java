/** Long seeded runs that show what the link holds: one class a campaign, one document for all. */
package campaign;
