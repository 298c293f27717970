package rasterlab.tests.rules;

import java.io.IOException;
import java.net.URI;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * Counts the operations of the Vector API that each method of a class holds, as the compiler sees
 * them: with those of the class's own methods that it calls and that take or return a vector, and
 * with one more for each number that first becomes a vector.
 */
final class VectorOperations extends ClassVisitor {
    private static final String VECTORS = "jdk/incubator/vector/";

    /** By name and descriptor, what is called by it, and how often. */
    private final Map<String, Map<String, Integer>> calls = new HashMap<>();

    private final Map<String, Integer> own = new HashMap<>();
    private String owner;

    private VectorOperations() {
        super(Opcodes.ASM9);
    }

    /** By a method's name, how many operations it holds; of methods that hold any. */
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
                if (of.startsWith(VECTORS) && !of.endsWith("Species"))
                    own.merge(method, operations(called, type), Integer::sum);
                else if (of.equals(owner) && type.contains("L" + VECTORS))
                    calls.computeIfAbsent(method, none -> new HashMap<>())
                            .merge(called + type, 1, Integer::sum);
            }
        };
    }

    /** Places in arrays and numbers that are asked for stay numbers. */
    private static int operations(String called, String descriptor) {
        Type[] arguments = Type.getArgumentTypes(descriptor);
        if (arguments.length == 0) return 1;
        int last = arguments[arguments.length - 1].getSort();
        boolean number = last == Type.INT || last == Type.FLOAT;
        return switch (called) {
            case "fromArray", "intoArray", "broadcast", "lane" -> 1;
            default -> number ? 2 : 1;
        };
    }
}
