package rasterlab.tests.rules;

import java.io.IOException;
import java.net.URI;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * Counts the operations of the Vector API that each method of a class holds, as the compiler sees
 * them: with those of the class's own methods that it calls, but those that are compiled on their
 * own, and with one more for each number that first becomes a vector.
 */
final class VectorOperations extends ClassVisitor {
    private static final String VECTORS = "jdk/incubator/vector/";

    /** See {@code engine/vector-options}. */
    private static final String ON_ITS_OWN = "InLanes";

    /** How many lanes a species has is a constant. */
    private static final String CONSTANT = "length";

    /** What is called by a name and descriptor, and how often. */
    private final Map<String, Map<String, Integer>> calls = new HashMap<>();

    private final Map<String, Integer> own = new HashMap<>();
    private String owner;

    private VectorOperations() {
        super(Opcodes.ASM9);
    }

    /** The number of operations that a method holds, by its name; of methods that hold any. */
    static Map<String, Integer> of(URI classFile) throws IOException {
        var counted = new VectorOperations();
        try (var in = classFile.toURL().openStream()) {
            new ClassReader(in).accept(counted, ClassReader.SKIP_DEBUG);
        }
        var operations = new TreeMap<String, Integer>();
        for (String method : counted.own.keySet()) {
            int count = counted.count(method);
            String name = method.substring(0, method.indexOf('('));
            if (count > 0) operations.merge(name, count, Math::max);
        }
        return operations;
    }

    private int count(String method) {
        int sum = own.getOrDefault(method, 0);
        for (var call : calls.getOrDefault(method, Map.of()).entrySet())
            sum += call.getValue() * count(call.getKey());
        return sum;
    }

    @Override
    public void visit(
            int version, int access, String name, String signature, String above, String[] with) {
        owner = name;
    }

    @Override
    public MethodVisitor visitMethod(
            int access, String name, String descriptor, String signature, String[] thrown) {
        String method = name + descriptor;
        own.put(method, 0);
        return new MethodVisitor(Opcodes.ASM9) {
            @Override
            public void visitMethodInsn(
                    int opcode, String of, String called, String type, boolean ofInterface) {
                if (of.startsWith(VECTORS) && !called.equals(CONSTANT))
                    own.merge(method, operations(called, type), Integer::sum);
                else if (of.equals(owner) && !called.endsWith(ON_ITS_OWN))
                    calls.computeIfAbsent(method, none -> new HashMap<>())
                            .merge(called + type, 1, Integer::sum);
                else if (!of.equals(owner)
                        && of.startsWith("rasterlab/")
                        && type.contains("L" + VECTORS))
                    throw new AssertionError(
                            owner + "." + name + " hands a vector to " + of + "." + called);
            }
        };
    }

    /** Places in arrays and numbers that are asked for stay numbers; a mask may come last. */
    private static int operations(String called, String descriptor) {
        if (Set.of("fromArray", "intoArray", "broadcast", "lane").contains(called)) return 1;
        for (Type argument : Type.getArgumentTypes(descriptor))
            if (argument.getSort() <= Type.DOUBLE) return 2;
        return 1;
    }
}
