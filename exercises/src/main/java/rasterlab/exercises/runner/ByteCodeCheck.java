package rasterlab.exercises.runner;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Message;

/**
 * Reads a student's class files before they run: an early refusal in words that can be understood.
 * What keeps them in is the child process, not this.
 */
final class ByteCodeCheck {
    private static final int LONGEST_NAME = 100;

    private final AllowList allowed;

    ByteCodeCheck(AllowList allowed) {
        this.allowed = allowed;
    }

    /**
     * What the classes found: the one to make an instance of, or why not.
     *
     * @param entry name of that class; empty where there are refusals
     */
    record Result(String entry, List<Diagnostic> refusals) {}

    /**
     * @param classes binary name to class file, as the compiling child sent them: may be anything
     * @param contract internal name of the interface that the exercise asks for
     */
    Result check(Map<String, byte[]> classes, String contract, String source) {
        Refusals refusals = new Refusals(source);
        OwnClasses own;
        try {
            own = new OwnClasses(classes.values());
            Uses uses = new Uses(allowed, own, refusals);
            for (byte[] bytes : classes.values())
                new ClassReader(bytes).accept(new ClassScan(uses), ClassReader.SKIP_FRAMES);
        } catch (RuntimeException malformed) {
            return refused("classes.unreadable", malformed);
        }
        for (String name : own.names()) {
            if (name.contains("/")) return packageRefused(packageOf(name), source);
            if (name.length() > LONGEST_NAME || !classes.containsKey(name))
                return refused("classes.name", LONGEST_NAME);
        }
        if (!refusals.list().isEmpty()) return new Result("", refusals.list());
        return entry(own, contract);
    }

    private static Result entry(OwnClasses own, String contract) {
        String readable = contract.replace('/', '.');
        List<String> entries = new ArrayList<>();
        for (String name : own.names())
            if (isPublicTopLevel(own, name) && own.lineage(name).contains(contract))
                entries.add(name);
        if (entries.isEmpty()) return refused("classes.none", readable);
        if (entries.size() > 1) return refused("classes.several", entries, readable);
        String entry = entries.get(0);
        if (!own.shape(entry).members().contains("public <init>()V"))
            return refused("classes.constructor", entry);
        return new Result(entry, List.of());
    }

    /** A nested class has its outer one's name and a dollar sign before its own. */
    private static boolean isPublicTopLevel(OwnClasses own, String name) {
        int access = own.shape(name).access();
        boolean concrete = (access & (Opcodes.ACC_ABSTRACT | Opcodes.ACC_INTERFACE)) == 0;
        return concrete && (access & Opcodes.ACC_PUBLIC) != 0 && !name.contains("$");
    }

    private static Result packageRefused(String name, String source) {
        List<String> lines = source.lines().takeWhile(line -> !line.contains("package")).toList();
        return new Result(
                "",
                List.of(new Diagnostic(lines.size() + 1, 0, Message.of("classes.package", name))));
    }

    private static String packageOf(String name) {
        return name.substring(0, name.lastIndexOf('/')).replace('/', '.');
    }

    private static Result refused(String key, Object... arguments) {
        return new Result("", List.of(new Diagnostic(0, 0, Message.of(key, arguments))));
    }
}
