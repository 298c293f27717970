package rasterlab.exercises.runner.scan;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.objectweb.asm.ConstantDynamic;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Type;

/** Judges single uses of types and members against the allow-list and the student's own classes. */
final class Uses {
    /** The only methods of the JDK that may link an invokedynamic instruction. */
    private static final Set<String> BOOTSTRAPS =
            Set.of(
                    "java/lang/invoke/LambdaMetafactory.metafactory",
                    "java/lang/invoke/LambdaMetafactory.altMetafactory",
                    "java/lang/invoke/StringConcatFactory.makeConcat",
                    "java/lang/invoke/StringConcatFactory.makeConcatWithConstants",
                    "java/lang/runtime/ObjectMethods.bootstrap",
                    "java/lang/runtime/SwitchBootstraps.typeSwitch",
                    "java/lang/runtime/SwitchBootstraps.enumSwitch");

    private final AllowList allowed;
    private final OwnClasses own;
    private final Refusals refusals;
    private final Map<String, Boolean> judged = new HashMap<>();

    Uses(AllowList allowed, OwnClasses own, Refusals refusals) {
        this.allowed = allowed;
        this.own = own;
        this.refusals = refusals;
    }

    void refuse(int line, String thing) {
        refusals.add(line, thing);
    }

    /** A class or array as an instruction names it: "java/util/List" or "[I". */
    void type(int line, String internalName) {
        if (internalName != null) type(line, Type.getObjectType(internalName));
    }

    void type(int line, Type type) {
        switch (type.getSort()) {
            case Type.ARRAY -> type(line, type.getElementType());
            case Type.METHOD -> {
                type(line, type.getReturnType());
                for (Type argument : type.getArgumentTypes()) type(line, argument);
            }
            case Type.OBJECT -> {
                String name = type.getInternalName();
                if (!own.contains(name) && !allowed.allows(name)) refusals.addClass(line, name);
            }
            default -> {
                // a primitive type
            }
        }
    }

    /** A method or field that an instruction or a handle names. */
    void member(int line, String owner, String name, String descriptor) {
        if (refusals.isFull()) return;
        boolean may =
                judged.computeIfAbsent(
                        owner + "." + name + descriptor, one -> mayUse(owner, name, descriptor));
        if (may) type(line, Type.getType(descriptor));
        else refuse(line, owner, name, descriptor);
    }

    private void refuse(int line, String owner, String name, String descriptor) {
        if (!refusals.isAnswer(line, owner)) {
            if (mayName(owner)) refusals.addMember(line, owner, name, allowed.some(owner));
            else type(line, owner);
        }
        Type type = Type.getType(descriptor);
        Type answer = type.getSort() == Type.METHOD ? type.getReturnType() : type;
        if (answer.getSort() == Type.OBJECT) refusals.addAnswer(line, answer.getInternalName());
    }

    private boolean mayName(String owner) {
        return owner.startsWith("[") || own.contains(owner) || allowed.allows(owner);
    }

    private boolean mayUse(String owner, String name, String descriptor) {
        if (owner.startsWith("[")) {
            type(0, owner);
            return name.equals("clone");
        }
        String member = name + descriptor;
        return own.lineage(owner).stream()
                .anyMatch(
                        one ->
                                own.contains(one)
                                        ? own.shape(one).members().contains(member)
                                        : allowed.allows(one, name));
    }

    /** What ldc loads or a bootstrap gets as an argument. */
    void constant(int line, Object constant) {
        if (constant instanceof Type type) type(line, type);
        else if (constant instanceof Handle handle)
            member(line, handle.getOwner(), handle.getName(), handle.getDesc());
        else if (constant instanceof ConstantDynamic) refusals.add(line, "dynamic constant");
    }

    void dynamicCall(int line, String descriptor, Handle bootstrap, Object... arguments) {
        String method = bootstrap.getOwner() + "." + bootstrap.getName();
        if (!BOOTSTRAPS.contains(method)) refusals.add(line, method);
        type(line, Type.getMethodType(descriptor));
        for (Object argument : arguments) constant(line, argument);
    }
}
