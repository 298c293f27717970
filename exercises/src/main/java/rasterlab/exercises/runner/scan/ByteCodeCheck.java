package rasterlab.exercises.runner.scan;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Message;

/**
 * Reads a student's class files before they run: an early refusal in words that can be understood.
 * What keeps them in is the child process, not this.
 */
public final class ByteCodeCheck {
    private static final int LONGEST_NAME = 100;
    private static final Pattern COMMENT = Pattern.compile("(?s)/\\*.*?\\*/|//[^\n]*");

    private final AllowList allowed;

    public ByteCodeCheck(AllowList allowed) {
        this.allowed = allowed;
    }

    /**
     * What the classes found: the one to make an instance of, or why not.
     *
     * @param entry name of that class; empty where there are refusals
     */
    public record Result(String entry, List<Diagnostic> refusals) {}

    /**
     * @param classes binary name to class file, as the compiling child sent them: may be anything
     * @param contract internal name of the interface that the exercise asks for
     */
    public Result check(Map<String, byte[]> classes, String contract, String source) {
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
            if (name.length() > LONGEST_NAME)
                return refused("classes.name", LONGEST_NAME, name.length());
            if (!classes.containsKey(name)) return refused("classes.unexpected", name);
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
        int line = lineOfPackage(source);
        return new Result(
                "", List.of(new Diagnostic(line, 0, Message.of("classes.package", name))));
    }

    /** Only comments may come before the package line. */
    private static int lineOfPackage(String source) {
        String code =
                COMMENT.matcher(source).replaceAll(found -> "\n".repeat(lineEnds(found.group())));
        Matcher found = Pattern.compile("\\bpackage\\b").matcher(code);
        return found.find() ? 1 + lineEnds(code.substring(0, found.start())) : 0;
    }

    private static int lineEnds(String text) {
        return (int) text.chars().filter(c -> c == '\n').count();
    }

    private static String packageOf(String name) {
        return name.substring(0, name.lastIndexOf('/')).replace('/', '.');
    }

    private static Result refused(String key, Object... arguments) {
        return new Result("", List.of(new Diagnostic(0, 0, Message.of(key, arguments))));
    }
}
