package rasterlab.exercises.runner.scan;

import org.objectweb.asm.AnnotationVisitor;
import org.objectweb.asm.Attribute;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/** Shows every instruction of one method that names a type or a member to {@link AccessCheck}. */
final class MethodScan extends MethodVisitor {
    private final AccessCheck uses;
    private int line;

    MethodScan(AccessCheck uses) {
        super(Opcodes.ASM9);
        this.uses = uses;
    }

    @Override
    public void visitLineNumber(int number, Label start) {
        line = number;
    }

    @Override
    public void visitTypeInsn(int opcode, String type) {
        uses.type(line, type);
    }

    @Override
    public void visitFieldInsn(int opcode, String owner, String name, String descriptor) {
        uses.member(line, owner, name, descriptor);
    }

    @Override
    public void visitMethodInsn(
            int opcode, String owner, String name, String descriptor, boolean ofInterface) {
        uses.member(line, owner, name, descriptor);
    }

    @Override
    public void visitInvokeDynamicInsn(
            String name, String descriptor, Handle bootstrap, Object... arguments) {
        uses.dynamicCall(line, descriptor, bootstrap, arguments);
    }

    @Override
    public void visitLdcInsn(Object value) {
        uses.constant(line, value);
    }

    @Override
    public void visitMultiANewArrayInsn(String descriptor, int dimensions) {
        uses.descriptor(line, descriptor);
    }

    @Override
    public void visitTryCatchBlock(Label start, Label end, Label handler, String type) {
        uses.type(0, type);
    }

    @Override
    public AnnotationVisitor visitAnnotation(String descriptor, boolean visible) {
        uses.descriptor(0, descriptor);
        return null;
    }

    @Override
    public AnnotationVisitor visitParameterAnnotation(
            int parameter, String descriptor, boolean visible) {
        uses.descriptor(0, descriptor);
        return null;
    }

    @Override
    public void visitAttribute(Attribute attribute) {
        uses.refuse(0, "class file attribute " + attribute.type);
    }
}
