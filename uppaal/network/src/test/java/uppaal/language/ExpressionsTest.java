package uppaal.language;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import uppaal.ModelException;

class ExpressionsTest {
    /** x is slot 0, y slot 1; nothing else has a value. */
    private static final Names NAMES = name -> switch (name) {
        case "x" -> Optional.of(new Term.Variable(0));
        case "y", "a[2]" -> Optional.of(new Term.Variable(1));
        default -> Optional.empty();
    };
    private static final int[] STATE = {7, 0};
    private static final Operator[] ALWAYS_DEFINED = Arrays.stream(Operator.values())
            .filter(operator -> operator != Operator.OVER && operator != Operator.SHIFTED).toArray(Operator[]::new);

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
            "1 + 2 * 3; 7", "(1 + 2) * 3; 9", "7 / 2 * 2; 6", "1 + x / 2; 4", "1 << 2 + 1; 8", "x << 1 < 15; 1",
            "10 - 3 - 2; 5", "-x + 10; 3", "- - 3; 3",
            "x == 7 && y == 0; 1", "x == 7 and !(y == 1); 1", "not y; 1", "!y == 1; 1", "not y == 0; 0",
            "1 || 0 && 0; 1", "(1 || 0) && 0; 0", "0 or 1; 1", "x > 6; 1", "x >= 8; 0", "x < 7; 0", "x <= 7; 1",
            "x != 7; 0",
            "1 < 2 == 1; 1", "0 imply 0; 1", "1 imply y; 0", "x == 7 imply y == 0; 1", "true; 1", "false; 0",
            "x ? 1 : 2; 1", "y ? 1 : x ? 2 : 3; 2", "y || x ? x + 1 : 0; 8", "1 ? 2 : 3; 2", "y == 0 ? -x : x; -7",
            "a[2]; 0", "a[1 + 1] + 1; 1",
            "x /* seven */ + 1 // eight; 8", "(((x))); 7"})
    void value_expression_isAsUppaalHasIt(String text, int expected) {
        assertEquals(expected, Expressions.parse(text, NAMES, "here").value(STATE));
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
            "x % 2; here: expected the end, not '%'",
            "1 / 0; here: a constant does not fit 32 bits, or is divided by 0",
            "1 << 31; here: a constant does not fit 32 bits, or is divided by 0",
            "x ? 1; here: expected ':', not the end",
            "x[y]; here: 'x[...]' with an index that is not constant is outside the subset that this checker reads",
            "x[0]; here: 'x[0]' has no value here",
            "a[1; here: expected ']', not the end",
            "P.a[3]; here: 'P.a[3]' has no value here",
            "forall (i : int[0,1]) x; here: 'forall' here, where a name is read, is outside the subset that this "
                    + "checker reads",
            "x' == 0; here: expected the end, not '''",
            "z; here: 'z' has no value here",
            "P.l; here: 'P.l' has no value here",
            "deadlock; here: 'deadlock' has a meaning in queries only",
            "1 imply 0 imply 1; here: put parentheses where 'imply' meets 'imply' or 'or'",
            "1 || 0 imply 1; here: put parentheses where 'imply' meets 'imply' or 'or'",
            "(x; here: expected ')', not the end",
            "x @ 1; here: the character '@' is outside the subset that this checker reads",
            "x /* open; here: a comment is not closed",
            "99999999999; here: 99999999999 does not fit 32 bits",
            "2147483647 + 1; here: a constant does not fit 32 bits, or is divided by 0"})
    void parse_outsideTheSubset_saysWhereAndWhat(String text, String message) {
        ModelException refused = assertThrows(ModelException.class, () -> Expressions.parse(text, NAMES, "here"));
        assertEquals(message, refused.getMessage());
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void value_randomExpression_isThatOfItsTree(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 500; i++) {
            Term tree = tree(random, 5);
            assertEquals(tree.value(STATE), Expressions.parse(written(tree), NAMES, "here").value(STATE),
                    () -> written(tree));
        }
    }

    @Test
    void parse_randomTokens_isRefusedInOneLineOrRead() {
        Random random = new Random(4);
        String[] pieces = {"x", "y", "(", ")", "imply", "||", "!", "-", "7", "==", "system", "/*", "*/", ".", "A", "[",
                "é", "//", " "};
        int refused = 0;
        for (int i = 0; i < 5000; i++) {
            StringBuilder text = new StringBuilder();
            for (int n = random.nextInt(8); n >= 0; n--) {
                text.append(pieces[random.nextInt(pieces.length)]).append(' ');
            }
            try {
                Expressions.parse(text.toString(), NAMES, "here");
            } catch (ModelException expected) {
                assertTrue(expected.getMessage().startsWith("here: ") && !expected.getMessage().contains("\n"));
                refused++;
            }
        }
        assertTrue(refused > 1000 && refused < 5000, "refused " + refused);
    }

    private static Term tree(Random random, int depth) {
        if (depth == 0 || random.nextInt(5) == 0) {
            return random.nextBoolean() ? new Term.Variable(random.nextInt(2)) : new Term.Constant(random.nextInt(4));
        }
        return switch (random.nextInt(9)) {
            case 2 -> new Term.Choice(tree(random, depth - 1), tree(random, depth - 1), tree(random, depth - 1));
            case 0 -> new Term.Not(tree(random, depth - 1));
            case 1 -> new Term.Negative(tree(random, depth - 1));
            default -> new Term.Binary(ALWAYS_DEFINED[random.nextInt(ALWAYS_DEFINED.length)],
                    tree(random, depth - 1), tree(random, depth - 1));
        };
    }

    private static String written(Term term) {
        if (term instanceof Term.Constant constant) {
            return String.valueOf(constant.number());
        } else if (term instanceof Term.Variable variable) {
            return variable.slot() == 0 ? "x" : "y";
        } else if (term instanceof Term.Not not) {
            return "!(" + written(not.operand()) + ")";
        } else if (term instanceof Term.Negative negative) {
            return "-(" + written(negative.operand()) + ")";
        } else if (term instanceof Term.Choice choice) {
            return "((" + written(choice.condition()) + ") ? " + written(choice.yes()) + " : " + written(choice.no())
                    + ")";
        }
        Term.Binary binary = (Term.Binary) term;
        return "(" + written(binary.left()) + " " + binary.operator().symbol() + " " + written(binary.right()) + ")";
    }
}
