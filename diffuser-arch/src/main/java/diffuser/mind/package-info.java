/** An agent's knowledge and wishes of its board: messages, questions, intentions that wait, openness. */
package diffuser.mind;
