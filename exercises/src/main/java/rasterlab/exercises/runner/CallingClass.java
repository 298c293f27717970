package rasterlab.exercises.runner;

import static org.objectweb.asm.Opcodes.AALOAD;
import static org.objectweb.asm.Opcodes.ACC_FINAL;
import static org.objectweb.asm.Opcodes.ACC_SUPER;
import static org.objectweb.asm.Opcodes.ACONST_NULL;
import static org.objectweb.asm.Opcodes.ALOAD;
import static org.objectweb.asm.Opcodes.ARETURN;
import static org.objectweb.asm.Opcodes.CHECKCAST;
import static org.objectweb.asm.Opcodes.INVOKEINTERFACE;
import static org.objectweb.asm.Opcodes.INVOKESPECIAL;
import static org.objectweb.asm.Opcodes.INVOKESTATIC;
import static org.objectweb.asm.Opcodes.INVOKEVIRTUAL;
import static org.objectweb.asm.Opcodes.RETURN;
import static org.objectweb.asm.Opcodes.SIPUSH;
import static org.objectweb.asm.Opcodes.V17;

import java.lang.invoke.MethodType;
import java.lang.reflect.Method;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Type;
import rasterlab.exercises.child.RunMain;

/** Writes the class by which a child calls a contract's method as directly as a source would. */
final class CallingClass {
    private static final String PACKAGE = RunMain.class.getPackageName().replace('.', '/') + '/';
    private static final String CALLING = PACKAGE + "Calling";

    private CallingClass() {}

    /**
     * The class file of one that extends the child's {@code Calling}.
     *
     * @param method of an interface
     */
    static byte[] of(Method method) {
        ClassWriter out = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        out.visit(V17, ACC_FINAL | ACC_SUPER, PACKAGE + "ContractCalling", null, CALLING, null);
        MethodVisitor make = out.visitMethod(0, "<init>", "()V", null, null);
        make.visitCode();
        make.visitVarInsn(ALOAD, 0);
        make.visitMethodInsn(INVOKESPECIAL, CALLING, "<init>", "()V", false);
        make.visitInsn(RETURN);
        make.visitMaxs(0, 0);
        make.visitEnd();
        MethodVisitor call =
                out.visitMethod(
                        0,
                        "call",
                        "(Ljava/lang/Object;[Ljava/lang/Object;)Ljava/lang/Object;",
                        null,
                        null);
        call.visitCode();
        writeCall(method, call);
        call.visitMaxs(0, 0);
        call.visitEnd();
        out.visitEnd();
        return out.toByteArray();
    }

    /** Casts the student's object and what it is given, calls, and boxes what is returned. */
    private static void writeCall(Method method, MethodVisitor out) {
        String contract = Type.getInternalName(method.getDeclaringClass());
        out.visitVarInsn(ALOAD, 1);
        out.visitTypeInsn(CHECKCAST, contract);
        Class<?>[] given = method.getParameterTypes();
        for (int i = 0; i < given.length; i++) {
            out.visitVarInsn(ALOAD, 2);
            out.visitIntInsn(SIPUSH, i);
            out.visitInsn(AALOAD);
            unbox(given[i], out);
        }
        out.visitMethodInsn(
                INVOKEINTERFACE,
                contract,
                method.getName(),
                Type.getMethodDescriptor(method),
                true);
        box(method.getReturnType(), out);
        out.visitInsn(ARETURN);
    }

    private static void unbox(Class<?> type, MethodVisitor out) {
        String boxed = boxed(type);
        out.visitTypeInsn(CHECKCAST, boxed);
        if (type.isPrimitive())
            out.visitMethodInsn(
                    INVOKEVIRTUAL,
                    boxed,
                    type.getName() + "Value",
                    "()" + Type.getDescriptor(type),
                    false);
    }

    private static void box(Class<?> type, MethodVisitor out) {
        if (type == void.class) out.visitInsn(ACONST_NULL);
        else if (type.isPrimitive())
            out.visitMethodInsn(
                    INVOKESTATIC,
                    boxed(type),
                    "valueOf",
                    "(" + Type.getDescriptor(type) + ")L" + boxed(type) + ";",
                    false);
    }

    private static String boxed(Class<?> type) {
        return Type.getInternalName(MethodType.methodType(type).wrap().returnType());
    }
}
