package uppaal.language;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import uppaal.ModelException;

class DeclarationsTest {
    private final List<String> allocated = new ArrayList<>();
    private final Scope scope = Scope.global();

    private final Declarations.Memory memory = new Declarations.Memory() {
        @Override
        public int allocate(String name, int low, int high, int initial) {
            allocated.add(name + "[" + low + "," + high + "]=" + initial);
            return allocated.size() - 1;
        }

        @Override
        public int allocateClock(String name) {
            allocated.add("clock " + name);
            return allocated.size() - 1;
        }
    };

    private void declare(String text) {
        Declarations.global(text, scope, memory, "here");
    }

    @Test
    void global_eachKind_isDeclared() {
        declare("const int N = 2 + 1, SQUARE = N * N; const bool YES = true;"
                + "int[0,N] a = N, b; int[-2,-1] c = -1; bool d = !YES; int e; chan f, g; broadcast chan h; clock x;"
                + "urgent chan u; urgent broadcast chan v;");

        assertEquals(List.of("a[0,3]=3", "b[0,3]=0", "c[-2,-1]=-1", "d[0,1]=0", "e[-32768,32767]=0", "clock x"),
                allocated);
        assertEquals(Optional.of(new Symbol.Number(9)), scope.find("SQUARE"));
        assertEquals(Optional.of(new Symbol.Number(1)), scope.find("YES"));
        assertEquals(Optional.of(new Symbol.Variable(2)), scope.find("c"));
        assertEquals(Optional.of(new Symbol.Channel("g", false)), scope.find("g"));
        assertEquals(Optional.of(new Symbol.Channel("h", true)), scope.find("h"));
        assertEquals(Optional.of(new Symbol.Channel("u", false, true)), scope.find("u"));
        assertEquals(Optional.of(new Symbol.Channel("v", true, true)), scope.find("v"));
    }

    @Test
    void global_arrays_haveTheirElementsDeclared() {
        declare("const int N = 2, SQUARES[N] = {1, 4}; int[0,N] a[N], b = 1; bool c[1] = {true}; clock x[2];"
                + "broadcast chan h[N];");

        assertEquals(List.of("a[0][0,2]=0", "a[1][0,2]=0", "b[0,2]=1", "c[0][0,1]=1", "clock x[0]", "clock x[1]"),
                allocated);
        assertEquals(Optional.of(new Symbol.Number(4)), scope.find("SQUARES[1]"));
        assertEquals(Optional.of(new Symbol.Variable(1)), scope.find("a[1]"));
        assertEquals(Optional.of(new Symbol.Channel("h[1]", true)), scope.find("h[1]"));
        assertEquals(Optional.empty(), scope.find("h[2]"));
        assertEquals(Optional.empty(), scope.term("a"));
    }

    @Test
    void find_arrayBehindALocalName_isHidden() {
        declare("int a[2];");
        Scope inner = scope.inner();
        assertEquals(Optional.of(new Symbol.Variable(1)), inner.find("a[1]"));
        Declarations.local("int a;", inner, memory, "here");
        assertEquals(Optional.empty(), inner.find("a[1]"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "clock x = 1;           | expected ';', not '='",
            "urgent a;              | expected 'chan', not 'a'",
            "typedef int[0,1] t;    | 'typedef' here, where a declaration is read, is outside the subset that this "
                    + "checker reads",
            "void f() { }           | 'void' here, where a declaration is read, is outside the subset that this "
                    + "checker reads",
            "int a[3] = {1, 2};     | expected ',', not '}'",
            "int a[2] = 1;          | expected '{', not '1'",
            "int a[0];              | 'a' has 0 elements",
            "int a[2][2];           | expected ';', not '['",
            "int a[2], a[1];        | 'a' is declared twice",
            "int n; int a[n];       | a constant is needed where a variable is used",
            "const int a[1];        | expected '=', not ';'",
            "int[0,1] a[2] = {0, 2}; | 'a[1]' is 2, outside its range [0,1]",
            "int a = b;             | 'b' has no value here",
            "int b; int a = b;      | a constant is needed where a variable is used",
            "int[0,1] a = 2;        | 'a' is 2, outside its range [0,1]",
            "int[1,2] a;            | 'a' is 0, outside its range [1,2]",
            "int[2,1] a;            | the range [2,1] is empty",
            "int a; bool a;         | 'a' is declared twice",
            "const int a;           | expected '=', not ';'",
            "int imply;             | 'imply' here, where a name is read, is outside the subset that this checker "
                    + "reads",
            "int a                  | expected ';', not the end"})
    void global_outsideTheSubset_saysWhat(String text, String message) {
        assertEquals("here: " + message, assertThrows(ModelException.class, () -> declare(text)).getMessage());
    }

    @Test
    void local_channel_isRefused() {
        ModelException refused = assertThrows(ModelException.class,
                () -> Declarations.local("chan a;", scope, memory, "here"));
        assertEquals("here: 'chan' here, where a declaration is read, is outside the subset that this checker reads",
                refused.getMessage());
    }

    @Test
    void parameters_withArguments_areConstants() {
        Declarations.parameters("const int[1,4] receivers, const bool loud", new int[] {2, 1}, scope, "here");

        assertEquals(Optional.of(new Symbol.Number(2)), scope.find("receivers"));
        assertEquals(Optional.of(new Symbol.Number(1)), scope.find("loud"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
            "const int[1,4] n             | 'n' is 5, outside its range [1,4]",
            "int n                        | 'int' here, where 'const' is read, is outside the subset that this "
                    + "checker reads",
            "const int n, const int m     | there is no argument for the parameter 'm'",
            "''                           | 1 arguments are given for 0 parameters"})
    void parameters_wrong_saysWhat(String text, String message) {
        ModelException refused = assertThrows(ModelException.class,
                () -> Declarations.parameters(text, new int[] {5}, scope, "here"));
        assertEquals("here: " + message, refused.getMessage());
    }
}
