package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("slow")
class VectorOperationsTest {
    /**
     * The most operations: with a few more the compiler may give up, not each time, see {@code
     * VectorLoops}.
     */
    private static final int MOST = 50;

    @Test
    void noLoopHoldsMoreThanTheCompilerSeesThrough() throws Exception {
        var loops = new TreeMap<String, Integer>();
        for (var type : new ClassFileImporter().importPackages("rasterlab.engine"))
            if (usesVectors(type))
                VectorOperations.of(type.getSource().orElseThrow().getUri())
                        .forEach(
                                (name, count) ->
                                        loops.put(type.getSimpleName() + "." + name, count));
        assertFalse(loops.isEmpty(), "no loops of vectors");
        var tooLarge = new TreeMap<>(loops);
        tooLarge.values().removeIf(count -> count <= MOST);
        assertEquals("{}", tooLarge.toString(), "more than " + MOST + " operations");
    }

    private static boolean usesVectors(JavaClass type) {
        return type.getDirectDependenciesFromSelf().stream()
                .anyMatch(use -> use.getTargetClass().getPackageName().startsWith("jdk.incubator"));
    }
}
