/** What plans and users are told of what went wrong. It depends on no other package of this module. */
package diffuser.report;
