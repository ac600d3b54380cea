package diffuser.mind;

/** An ability of a MAS beyond its borders; the names are those of the symbols in the paper's figure 1. */
public enum Ability {
    /**
     * Direct communication (the paper's definition 1): an agent of this MAS and one of another exchange messages from
     * end to end, over whatever infrastructure.
     */
    COM,
    /** Mobility: agents leave this MAS for another, and others' agents enter it. */
    MOB
}
