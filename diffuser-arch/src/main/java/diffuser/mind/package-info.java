/** What of its board an agent knows and wants: messages, questions, intentions that wait, openness. */
package diffuser.mind;
