/** Error reports to plans and users. It depends on no other package of this module. */
package diffuser.report;
