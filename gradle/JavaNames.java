import com.sun.source.tree.AnnotationTree;
import com.sun.source.tree.BlockTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.DoWhileLoopTree;
import com.sun.source.tree.EmptyStatementTree;
import com.sun.source.tree.EnhancedForLoopTree;
import com.sun.source.tree.ForLoopTree;
import com.sun.source.tree.IdentifierTree;
import com.sun.source.tree.IfTree;
import com.sun.source.tree.ImportTree;
import com.sun.source.tree.LiteralTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.ModifiersTree;
import com.sun.source.tree.PackageTree;
import com.sun.source.tree.StatementTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.tree.WhileLoopTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.TreePathScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.lang.model.element.Modifier;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** Names what Java files have against the rules that no formatter sees to: braces, columns, imports and names. */
class JavaNames extends TreePathScanner<Void, Void> {

    private static final int COLUMNS = 120;
    private static final String VARIABLE = "[a-z][a-zA-Z0-9]*";
    private static final String CONSTANT = "[A-Z][A-Z0-9]*(_[A-Z0-9]+)*|serialVersionUID";
    private static final String METHOD = "[a-z][a-zA-Z0-9]*(_[a-z0-9][a-zA-Z0-9]*)*";
    private static final String TYPE = "[A-Z][a-zA-Z0-9]*";
    /** What Jason keeps to its own package is reached from there only. */
    private static final String PACKAGE = "jason\\.asSemantics|[a-z]+(\\.[a-z][a-z0-9]*)*";
    /** A class of Jason's actions has the action's name. */
    private static final Pattern ACTIONS =
            Pattern.compile("(stdlib|argo|difuser|mqtt|test|bench)/([a-z_]+/)*[a-z]\\w*\\.java$");
    private static final Pattern TEST = Pattern.compile(
            "@(Test|ParameterizedTest)\n((?! +(\\w+ )*void \\w+\\()[^\n]*\n){0,40}"
                    + " +(\\w+ )*void (?![a-z][a-zA-Z0-9]*(_[a-z0-9][a-zA-Z0-9]*){1,2}\\()");
    private static final List<String> MODIFIERS = List.of("public", "protected", "private", "abstract", "default",
            "static", "sealed", "non-sealed", "final", "transient", "volatile", "synchronized", "native", "strictfp");
    private static final Pattern REFERENCE =
            Pattern.compile("@(?:link|linkplain|see|throws|exception|value)\\b[^}\n]*");

    private final SourcePositions positions;
    private CompilationUnitTree unit;
    private String text;
    private Set<String> used;
    private long typeOfLast;
    private boolean differs;

    JavaNames(SourcePositions positions) {
        this.positions = positions;
    }

    public static void main(String[] files) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        boolean differs = false;
        try (StandardJavaFileManager manager =
                compiler.getStandardFileManager(null, Locale.ROOT, StandardCharsets.UTF_8)) {
            JavacTask task = (JavacTask) compiler.getTask(null, manager, wrong -> {
                throw new IllegalArgumentException(wrong.toString());
            }, List.of("-proc:none"), null, manager.getJavaFileObjects(files));
            JavaNames names = new JavaNames(Trees.instance(task).getSourcePositions());
            for (CompilationUnitTree unit : task.parse()) {
                names.check(unit);
            }
            differs = names.differs;
        }
        System.exit(differs ? 1 : 0);
    }

    private void check(CompilationUnitTree each) throws IOException {
        unit = each;
        text = unit.getSourceFile().getCharContent(true).toString();
        String[] lines = text.split("\n");
        for (int i = 0; i < lines.length; i++) {
            boolean isName = lines[i].startsWith("import ") || lines[i].startsWith("package ");
            expect(lines[i].length() <= COLUMNS || isName, i + 1, "a line has at most " + COLUMNS + " columns");
            expect(!lines[i].contains("\t"), i + 1, "a tab");
        }
        TEST.matcher(text).results().forEach(test -> expect(false, line(test.end()),
                "a test is named subject_result or subject_condition_result"));
        used = new HashSet<>();
        REFERENCE.matcher(text).results().map(MatchResult::group)
                .forEach(words -> used.addAll(List.of(words.split("\\W+"))));
        typeOfLast = -1;
        scan(unit, null);
        checkImports();
    }

    private void checkImports() {
        String ours = unit.getPackage() == null ? "" : unit.getPackage().getPackageName().toString();
        Set<String> seen = new HashSet<>();
        for (ImportTree each : unit.getImports()) {
            String name = each.getQualifiedIdentifier().toString();
            int dot = name.lastIndexOf('.');
            String from = name.substring(0, dot);
            expect(!name.endsWith(".*"), each, "an import of all that there is");
            expect(name.endsWith(".*") || used.contains(name.substring(dot + 1)), each, "an unused import: " + name);
            boolean isThere = !each.isStatic() && (from.equals("java.lang") || from.equals(ours));
            expect(seen.add(each.isStatic() + name) && !isThere, each, "a redundant import: " + name);
        }
    }

    private long line(long position) {
        return unit.getLineMap().getLineNumber(Math.max(position, 0));
    }

    private void expect(boolean right, Tree place, String wrong) {
        expect(right, line(positions.getStartPosition(unit, place)), wrong);
    }

    private void expect(boolean right, long line, String wrong) {
        if (!right) {
            differs = true;
            System.err.println(unit.getSourceFile().getName() + ":" + line + ": " + wrong);
        }
    }

    private void expectName(String name, String pattern, Tree place) {
        expect(name.matches(pattern), place, "the name " + name + " is not " + pattern);
    }

    private String source(Tree tree) {
        int start = (int) positions.getStartPosition(unit, tree);
        int end = (int) positions.getEndPosition(unit, tree);
        return start < 0 || end < 0 ? "" : text.substring(start, end);  // it is not written
    }

    @Override
    public Void visitCompilationUnit(CompilationUnitTree tree, Void none) {
        List<String> types = tree.getTypeDecls().stream().filter(ClassTree.class::isInstance)
                .map(type -> ((ClassTree) type).getSimpleName().toString()).toList();
        String file = Path.of(tree.getSourceFile().getName()).getFileName().toString().replace(".java", "");
        expect(types.isEmpty() || types.equals(List.of(file)), 1, "the file has one class of its name, not " + types);
        return super.visitCompilationUnit(tree, none);
    }

    @Override
    public Void visitPackage(PackageTree tree, Void none) {
        expectName(tree.getPackageName().toString(), PACKAGE, tree);
        return super.visitPackage(tree, none);
    }

    @Override
    public Void visitImport(ImportTree tree, Void none) {
        return null;  // its words are no use
    }

    @Override
    public Void visitIdentifier(IdentifierTree tree, Void none) {
        used.add(tree.getName().toString());
        return null;
    }

    @Override
    public Void visitClass(ClassTree tree, Void none) {
        String name = tree.getSimpleName().toString();
        if (!name.isEmpty() && !ACTIONS.matcher(unit.getSourceFile().getName()).find()) {
            expectName(name, TYPE, tree);
        }
        return super.visitClass(tree, none);
    }

    @Override
    public Void visitMethod(MethodTree tree, Void none) {
        if (!tree.getName().contentEquals("<init>")) {
            expectName(tree.getName().toString(), METHOD, tree);
        }
        return super.visitMethod(tree, none);
    }

    @Override
    public Void visitVariable(VariableTree tree, Void none) {
        Tree parent = getCurrentPath().getParentPath().getLeaf();
        String name = tree.getName().toString();
        boolean isField = parent instanceof ClassTree;
        String declared = source(tree);
        // A constant of an enum has no type before it.
        if (!isField || !declared.replaceFirst("^(@\\w+\\s+)+", "").matches("(?s)" + name + "\\b.*")) {
            Set<Modifier> flags = tree.getModifiers().getFlags();
            boolean isConstant = isField && (flags.containsAll(Set.of(Modifier.STATIC, Modifier.FINAL))
                    || parent.getKind() == Tree.Kind.INTERFACE || parent.getKind() == Tree.Kind.ANNOTATION_TYPE);
            expectName(name, isConstant ? CONSTANT : VARIABLE, tree);
        }
        long type = tree.getType() == null ? -1 : positions.getStartPosition(unit, tree.getType());
        expect(type < 0 || type != typeOfLast || parent instanceof ForLoopTree, tree,
                "two variables in one declaration");
        typeOfLast = type;
        String initial = tree.getInitializer() == null ? "" : source(tree.getInitializer());
        String variable = declared.substring(0, declared.length() - initial.length());
        expect(!variable.matches("(?s).*\\b" + name + "\\s*\\[\\s*\\].*"), tree,
                "an array's brackets are behind its type");
        return super.visitVariable(tree, none);
    }

    @Override
    public Void visitModifiers(ModifiersTree tree, Void none) {
        String words = source(tree).replaceFirst("@$", "");  // of an annotation's declaration
        for (AnnotationTree annotation : tree.getAnnotations()) {
            words = words.replace(source(annotation), "@");
        }
        List<Integer> order = Stream.of(words.replaceAll("//[^\n]*|/\\*(?s:.*?)\\*/", " ").trim().split("\\s+"))
                .map(MODIFIERS::indexOf).toList();
        expect(order.equals(order.stream().sorted().toList()), tree, "modifiers have this order: " + MODIFIERS);
        return super.visitModifiers(tree, none);
    }

    @Override
    public Void visitLiteral(LiteralTree tree, Void none) {
        expect(tree.getKind() != Tree.Kind.LONG_LITERAL || source(tree).endsWith("L"), tree,
                "a long number ends with L");
        return null;
    }

    @Override
    public Void visitEmptyStatement(EmptyStatementTree tree, Void none) {
        expect(false, tree, "an empty statement");
        return null;
    }

    private void expectBraces(StatementTree body, Tree of) {
        expect(body instanceof BlockTree, of, "braces are missing");
    }

    @Override
    public Void visitIf(IfTree tree, Void none) {
        expectBraces(tree.getThenStatement(), tree);
        if (tree.getElseStatement() != null && !(tree.getElseStatement() instanceof IfTree)) {
            expectBraces(tree.getElseStatement(), tree.getElseStatement());
        }
        return super.visitIf(tree, none);
    }

    @Override
    public Void visitForLoop(ForLoopTree tree, Void none) {
        expectBraces(tree.getStatement(), tree);
        return super.visitForLoop(tree, none);
    }

    @Override
    public Void visitEnhancedForLoop(EnhancedForLoopTree tree, Void none) {
        expectBraces(tree.getStatement(), tree);
        return super.visitEnhancedForLoop(tree, none);
    }

    @Override
    public Void visitWhileLoop(WhileLoopTree tree, Void none) {
        expectBraces(tree.getStatement(), tree);
        return super.visitWhileLoop(tree, none);
    }

    @Override
    public Void visitDoWhileLoop(DoWhileLoopTree tree, Void none) {
        expectBraces(tree.getStatement(), tree);
        return super.visitDoWhileLoop(tree, none);
    }
}
