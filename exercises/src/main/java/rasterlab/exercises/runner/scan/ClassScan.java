package rasterlab.exercises.runner.scan;

import org.objectweb.asm.AnnotationVisitor;
import org.objectweb.asm.Attribute;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.ModuleVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.RecordComponentVisitor;
import org.objectweb.asm.TypePath;

/** Shows everything that one class file can reach to {@link AccessCheck}. */
final class ClassScan extends ClassVisitor {
    private final AccessCheck uses;

    ClassScan(AccessCheck uses) {
        super(Opcodes.ASM9);
        this.uses = uses;
    }

    @Override
    public void visit(
            int version, int access, String name, String signature, String parent, String[] more) {
        uses.type(0, parent);
        for (String one : more) uses.type(0, one);
    }

    @Override
    public ModuleVisitor visitModule(String name, int access, String version) {
        uses.refuse(0, "module");
        return null;
    }

    @Override
    public FieldVisitor visitField(
            int access, String name, String descriptor, String signature, Object value) {
        uses.descriptor(0, descriptor);
        return new FieldScan();
    }

    @Override
    public MethodVisitor visitMethod(
            int access, String name, String descriptor, String signature, String[] thrown) {
        if ((access & Opcodes.ACC_NATIVE) != 0) uses.refuse(0, "native");
        if (name.equals("finalize") && descriptor.equals("()V")) uses.refuse(0, "finalize");
        uses.descriptor(0, descriptor);
        if (thrown != null) for (String one : thrown) uses.type(0, one);
        return new MethodScan(uses);
    }

    @Override
    public RecordComponentVisitor visitRecordComponent(
            String name, String descriptor, String signature) {
        uses.descriptor(0, descriptor);
        return null;
    }

    @Override
    public AnnotationVisitor visitAnnotation(String descriptor, boolean visible) {
        uses.descriptor(0, descriptor);
        return null;
    }

    @Override
    public AnnotationVisitor visitTypeAnnotation(
            int reference, TypePath path, String descriptor, boolean visible) {
        uses.descriptor(0, descriptor);
        return null;
    }

    @Override
    public void visitAttribute(Attribute attribute) {
        uses.refuse(0, "class file attribute " + attribute.type);
    }

    /** Looks at a field's annotations. */
    private final class FieldScan extends FieldVisitor {
        FieldScan() {
            super(Opcodes.ASM9);
        }

        @Override
        public AnnotationVisitor visitAnnotation(String descriptor, boolean visible) {
            uses.descriptor(0, descriptor);
            return null;
        }

        @Override
        public void visitAttribute(Attribute attribute) {
            uses.refuse(0, "class file attribute " + attribute.type);
        }
    }
}
