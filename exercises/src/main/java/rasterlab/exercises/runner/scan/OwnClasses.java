package rasterlab.exercises.runner.scan;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** The student's own classes: what each declares and what it inherits from. */
final class OwnClasses {
    /**
     * @param access flags of the class file
     * @param parents superclass first, then interfaces; internal names
     * @param members each declared field and method
     * @param constructible whether everybody may make an instance from nothing
     */
    record ClassShape(
            int access, List<String> parents, Set<Member> members, boolean constructible) {}

    /**
     * Shares the texts of its class file, in which many members may have one long descriptor. In an
     * order, so that a map of names that were chosen to have one hash code stays fast.
     */
    record Member(String name, String descriptor) implements Comparable<Member> {
        private static final Comparator<Member> ORDER =
                Comparator.comparing(Member::name).thenComparing(Member::descriptor);

        @Override
        public int compareTo(Member other) {
            return ORDER.compare(this, other);
        }
    }

    private final Map<String, ClassShape> shapes = new HashMap<>();
    private final Map<String, Set<String>> lineages = new HashMap<>();

    /**
     * @throws RuntimeException when the bytes are no class file
     */
    OwnClasses(Iterable<byte[]> classFiles) {
        for (byte[] bytes : classFiles) {
            ClassReader reader = new ClassReader(bytes);
            Declarations declared = new Declarations();
            reader.accept(declared, ClassReader.SKIP_CODE);
            List<String> parents = new ArrayList<>();
            if (reader.getSuperName() != null) parents.add(reader.getSuperName());
            parents.addAll(List.of(reader.getInterfaces()));
            shapes.put(
                    reader.getClassName(),
                    new ClassShape(
                            reader.getAccess(), parents, declared.members, declared.constructible));
        }
    }

    /** Collects what one class declares. */
    private static final class Declarations extends ClassVisitor {
        private final Set<Member> members = new HashSet<>();
        private boolean constructible;

        Declarations() {
            super(Opcodes.ASM9);
        }

        @Override
        public FieldVisitor visitField(
                int access, String name, String type, String signature, Object value) {
            members.add(new Member(name, type));
            return null;
        }

        @Override
        public MethodVisitor visitMethod(
                int access, String name, String type, String signature, String[] thrown) {
            members.add(new Member(name, type));
            constructible |=
                    (access & Opcodes.ACC_PUBLIC) != 0
                            && name.equals("<init>")
                            && type.equals("()V");
            return null;
        }
    }

    boolean contains(String type) {
        return shapes.containsKey(type);
    }

    Set<String> names() {
        return shapes.keySet();
    }

    ClassShape shape(String type) {
        return shapes.get(type);
    }

    /**
     * The class and all that it inherits from, each once however many ways lead there: a lattice of
     * interfaces has more ways than can be walked, and a class file may name itself as its parent.
     * Ends at classes that are not the student's own.
     */
    Set<String> lineage(String type) {
        return lineages.computeIfAbsent(type, this::walk);
    }

    private Set<String> walk(String type) {
        Set<String> met = new LinkedHashSet<>();
        Deque<String> open = new ArrayDeque<>(List.of(type));
        while (!open.isEmpty()) {
            String next = open.remove();
            if (met.add(next) && contains(next)) open.addAll(shape(next).parents());
        }
        return met;
    }
}
