package rasterlab.exercises.runner.scan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.objectweb.asm.Opcodes.ACC_ABSTRACT;
import static org.objectweb.asm.Opcodes.ACC_INTERFACE;
import static org.objectweb.asm.Opcodes.ACC_PUBLIC;
import static org.objectweb.asm.Opcodes.H_INVOKESTATIC;
import static org.objectweb.asm.Opcodes.INVOKESPECIAL;
import static org.objectweb.asm.Opcodes.RETURN;
import static org.objectweb.asm.Opcodes.V17;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import rasterlab.contract.LineRasterizer;
import rasterlab.exercises.score.Diagnostic;

/** Class files as no compiler makes them: the compiling child may be in a student's hands. */
class ByteCodeCheckTest {
    private static final String OBJECT = "java/lang/Object";

    private final Map<String, byte[]> classes = new LinkedHashMap<>();

    @Test
    @DisplayName("interfaces are walked along each of 2^90 ways")
    void eachInterfaceIsLookedAtOnce() {
        add("A0", ACC_INTERFACE | ACC_ABSTRACT, OBJECT);
        add("B0", ACC_INTERFACE | ACC_ABSTRACT, OBJECT);
        for (int i = 1; i <= 90; i++) {
            String[] below = {"A" + (i - 1), "B" + (i - 1)};
            add("A" + i, ACC_INTERFACE | ACC_ABSTRACT, OBJECT, below);
            add("B" + i, ACC_INTERFACE | ACC_ABSTRACT, OBJECT, below);
        }
        add("Mine", 0, OBJECT, "A90", "B90");
        assertEquals(List.of("Mine.exit is not allowed in this exercise"), refused("Mine"));
    }

    @Test
    @DisplayName("a class that inherits from itself overflows the judge's stack")
    void aCircleOfClassesEnds() {
        add("A", 0, "B");
        add("B", 0, "A");
        assertEquals(List.of("A.exit is not allowed in this exercise"), refused("A"));
    }

    @Test
    @DisplayName("a class under another name is told to have a long one")
    void aClassUnderAnotherNameIsNamed() {
        add("Mine", 0, OBJECT);
        classes.put("Other", classes.remove("Mine"));
        assertEquals(
                List.of("the class files do not fit together: Mine is in none of that name"),
                refused(OBJECT, "hashCode", "()I"));
    }

    @Test
    @DisplayName("a call is bound to its method by a method of the student's own")
    void anotherBootstrapIsRefused() {
        var own = new Handle(H_INVOKESTATIC, "Caller", "bind", "()V", false);
        assertEquals(
                List.of("Caller.bind is not allowed in this exercise"),
                refused(code -> code.visitInvokeDynamicInsn("run", "()V", own)));
    }

    private void add(String name, int access, String parent, String... interfaces) {
        ClassWriter writer = new ClassWriter(0);
        writer.visit(V17, ACC_PUBLIC | access, name, null, parent, interfaces);
        writer.visitEnd();
        classes.put(name, writer.toByteArray());
    }

    /** The message for a class that calls a method which that type has not. */
    private List<String> refused(String type) {
        return refused(type, "exit", "()V");
    }

    private List<String> refused(String type, String method, String descriptor) {
        return refused(
                code -> code.visitMethodInsn(INVOKESPECIAL, type, method, descriptor, false));
    }

    private List<String> refused(Consumer<MethodVisitor> calling) {
        ClassWriter writer = new ClassWriter(0);
        writer.visit(V17, ACC_PUBLIC, "Caller", null, OBJECT, null);
        MethodVisitor code = writer.visitMethod(ACC_PUBLIC, "call", "()V", null, null);
        code.visitCode();
        calling.accept(code);
        code.visitInsn(RETURN);
        code.visitMaxs(1, 1);
        code.visitEnd();
        classes.put("Caller", writer.toByteArray());
        ByteCodeCheck check = new ByteCodeCheck(AllowList.of(LineRasterizer.class));
        // a bound only so that the mistake ends at all
        return assertTimeoutPreemptively(
                        Duration.ofMinutes(5),
                        () -> check.check(classes, "rasterlab/contract/LineRasterizer", ""))
                .refusals()
                .stream()
                .map(Diagnostic::message)
                .toList();
    }
}
