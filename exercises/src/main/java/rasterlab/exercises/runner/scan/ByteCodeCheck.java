package rasterlab.exercises.runner.scan;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Message;

/**
 * Reads a student's class files before they run: an early refusal in words that can be understood.
 * What keeps them in is the child process, not this.
 */
public final class ByteCodeCheck {
    private static final int LONGEST_NAME = 100;

    private final AllowList allowed;

    public ByteCodeCheck(AllowList allowed) {
        this.allowed = allowed;
    }

    /**
     * The result of the check: the class to make an instance of, or why there is none.
     *
     * @param entry name of that class; empty where there are refusals
     */
    public record Result(String entry, List<Diagnostic> refusals) {}

    /**
     * @param classes binary name to class file, as the compiling child sent them: may be anything
     * @param contract internal name of the interface that the exercise asks for
     */
    public Result check(Map<String, byte[]> classes, String contract, String source) {
        try {
            OwnClasses own = new OwnClasses(classes.values());
            Optional<Result> misnamed = misnamed(own, classes.keySet(), source);
            if (misnamed.isPresent()) return misnamed.get();
            List<Diagnostic> refusals = refusals(classes.values(), own, source);
            return refusals.isEmpty() ? entry(own, contract) : new Result("", refusals);
        } catch (RuntimeException malformed) {
            return refused("classes.unreadable", malformed);
        }
    }

    private static Optional<Result> misnamed(OwnClasses own, Set<String> names, String source) {
        for (String name : own.names()) {
            if (name.contains("/")) return Optional.of(packageRefused(packageOf(name), source));
            if (name.length() > LONGEST_NAME)
                return Optional.of(refused("classes.name", LONGEST_NAME, name.length()));
            if (!names.contains(name)) return Optional.of(refused("classes.unexpected", name));
        }
        return Optional.empty();
    }

    private List<Diagnostic> refusals(Iterable<byte[]> classes, OwnClasses own, String source) {
        SourceRefusals refusals = new SourceRefusals(source);
        for (byte[] bytes : classes) {
            AccessCheck uses = new AccessCheck(allowed, own, refusals);
            new ClassReader(bytes).accept(new ClassScan(uses), ClassReader.SKIP_FRAMES);
        }
        return refusals.list();
    }

    private static Result entry(OwnClasses own, String contract) {
        String readable = contract.replace('/', '.');
        List<String> entries = new ArrayList<>();
        for (String name : own.names())
            if (isPublicTopLevel(own, name) && own.lineage(name).contains(contract))
                entries.add(name);
        if (entries.isEmpty()) return refused("classes.none", readable);
        if (entries.size() > 1)
            return refused("classes.several", String.join(", ", entries), readable);
        String entry = entries.get(0);
        if (!own.shape(entry).constructible()) return refused("classes.constructor", entry);
        return new Result(entry, List.of());
    }

    /** A nested class has its outer one's name and a dollar sign before its own. */
    private static boolean isPublicTopLevel(OwnClasses own, String name) {
        int access = own.shape(name).access();
        boolean concrete = (access & (Opcodes.ACC_ABSTRACT | Opcodes.ACC_INTERFACE)) == 0;
        return concrete && (access & Opcodes.ACC_PUBLIC) != 0 && !name.contains("$");
    }

    private static Result packageRefused(String name, String source) {
        int line = lineOfPackage(source);
        return new Result(
                "", List.of(new Diagnostic(line, 0, Message.of("classes.package", name))));
    }

    /** Annotations may come before it, and comments that speak of packages. */
    private static int lineOfPackage(String source) {
        return WordPlaces.in(source, Set.of("package"), Set.of()).firstLine("package");
    }

    private static String packageOf(String name) {
        return Wire.cut(name.substring(0, name.lastIndexOf('/')).replace('/', '.'));
    }

    private static Result refused(String key, Object... arguments) {
        return new Result("", List.of(new Diagnostic(0, 0, Message.of(key, arguments))));
    }
}
