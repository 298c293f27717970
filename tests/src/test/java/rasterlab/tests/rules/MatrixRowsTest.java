package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.MethodInvocationTree;
import com.sun.source.tree.NewClassTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.tests.Repository;

/** A matrix in the code is read as in a book: row under row, each on a line of its own. */
class MatrixRowsTest {
    /** How many numbers a row has, by the numbers of the whole matrix. */
    private static final Map<Integer, Integer> ROW = Map.of(16, 4, 9, 3);

    /** Methods that fill a matrix with as many numbers, in order of rows. */
    private static final Set<String> FILLS = Set.of("set", "setTransposed", "rows");

    @Test
    void matricesStandAsRows() throws IOException {
        var files = new ArrayList<Path>();
        for (Path file : Repository.sources(".java"))
            if (Repository.root().relativize(file).toString().contains("/src/main/"))
                if (Repository.text(file).contains("Matrix")) files.add(file);
        assertTrue(files.size() > 5, "no matrices were found to look at");
        try (var manager =
                ToolProvider.getSystemJavaCompiler().getStandardFileManager(null, null, null)) {
            var found = new ArrayList<String>();
            for (JavaFileObject file : manager.getJavaFileObjectsFromPaths(files))
                found.addAll(wrong(file));
            assertEquals(
                    List.of(),
                    found,
                    "write each row of these matrices on a line of its own and end it with //, which keeps it");
        }
    }

    static Stream<Arguments> texts() {
        return Stream.of(
                argumentSet("a row has two lines", "1, 2, //\n3, 4, 5, 6, //\n7, 8, 9", false),
                argumentSet("all rows are one line", "1, 2, 3, 4, 5, 6, 7, 8, 9", false),
                argumentSet("rows are not seen", "1, 2, 3, //\n4, f(5), 6, //\n7, 8, 9", true),
                argumentSet(
                        "numbers of a call are not seen",
                        "m.set(1, 2, 3, 4, 5, 6, 7, 8, 9)",
                        false));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("texts")
    @DisplayName("the rule does not see how a matrix stands")
    void seesRows(String numbers, boolean right) throws IOException {
        String text = "class A { Object a = new Matrix3d(" + numbers + "); }";
        var file =
                new SimpleJavaFileObject(URI.create("text:///A.java"), JavaFileObject.Kind.SOURCE) {
                    @Override
                    public CharSequence getCharContent(boolean ignored) {
                        return text;
                    }
                };
        assertEquals(right, wrong(file).isEmpty());
    }

    private static List<String> wrong(JavaFileObject file) throws IOException {
        var compiler = ToolProvider.getSystemJavaCompiler();
        var task = (JavacTask) compiler.getTask(null, null, d -> {}, null, null, List.of(file));
        var wrong = new ArrayList<String>();
        for (CompilationUnitTree unit : task.parse())
            unit.accept(
                    new TreeScanner<Void, Void>() {
                        @Override
                        public Void visitNewClass(NewClassTree made, Void nothing) {
                            if (made.getIdentifier().toString().contains("Matrix"))
                                look(made, made.getArguments());
                            return super.visitNewClass(made, nothing);
                        }

                        @Override
                        public Void visitMethodInvocation(MethodInvocationTree call, Void nothing) {
                            String name = call.getMethodSelect().toString();
                            if (FILLS.contains(name.substring(name.lastIndexOf('.') + 1)))
                                look(call, call.getArguments());
                            return super.visitMethodInvocation(call, nothing);
                        }

                        private void look(Tree tree, List<? extends ExpressionTree> numbers) {
                            Integer width = ROW.get(numbers.size());
                            if (width != null
                                    && !stands(unit, numbers, width, Trees.instance(task)))
                                wrong.add(place(unit, tree, task) + ": " + tree);
                        }
                    },
                    null);
        return wrong;
    }

    private static String place(CompilationUnitTree unit, Tree made, JavacTask task) {
        long at = Trees.instance(task).getSourcePositions().getStartPosition(unit, made);
        return unit.getSourceFile().getName() + ":" + unit.getLineMap().getLineNumber(at);
    }

    private static boolean stands(
            CompilationUnitTree unit,
            List<? extends ExpressionTree> numbers,
            int width,
            Trees trees) {
        var lines = new LinkedHashMap<Long, Integer>();
        for (ExpressionTree number : numbers) {
            long at = trees.getSourcePositions().getStartPosition(unit, number);
            lines.merge(unit.getLineMap().getLineNumber(at), 1, Integer::sum);
        }
        return lines.values().stream().allMatch(count -> count == width);
    }
}
