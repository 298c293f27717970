package rasterlab.exercises.runner.scan;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.objectweb.asm.ConstantDynamic;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Type;
import rasterlab.exercises.runner.scan.OwnClasses.Member;

/** Judges single uses of types and members against the allow-list and the student's own classes. */
final class AccessCheck {
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
    private final SourceRefusals refusals;

    /** Whether each member that was met may be used, by its owner. */
    private final Map<String, Map<Member, Boolean>> judged = new HashMap<>();

    /** The classes that may not be used, by the internal name that names them. */
    private final Map<String, List<String>> refusedNames = new HashMap<>();

    /** The classes that may not be used, by the descriptor that names them. */
    private final Map<String, List<String>> refusedIn = new HashMap<>();

    /**
     * One for each class file: its instructions share its texts, so that finding one again that was
     * met compares no text, and a long name costs nothing where it is used often.
     */
    AccessCheck(AllowList allowed, OwnClasses own, SourceRefusals refusals) {
        this.allowed = allowed;
        this.own = own;
        this.refusals = refusals;
    }

    void refuse(int line, String thing) {
        refusals.add(line, thing);
    }

    /** Notes a class or array as an instruction names it: "java/util/List" or "[I". */
    void type(int line, String internalName) {
        if (internalName == null) return;
        refusedNames
                .computeIfAbsent(internalName, one -> refused(Type.getObjectType(one)))
                .forEach(name -> refusals.addClass(line, name));
    }

    /** Notes the classes that the type of a field or method names. */
    void descriptor(int line, String descriptor) {
        refusedIn
                .computeIfAbsent(descriptor, one -> refused(Type.getType(one)))
                .forEach(name -> refusals.addClass(line, name));
    }

    private List<String> refused(Type type) {
        return switch (type.getSort()) {
            case Type.ARRAY -> refused(type.getElementType());
            case Type.METHOD ->
                    Stream.concat(
                                    Stream.of(type.getReturnType()),
                                    Stream.of(type.getArgumentTypes()))
                            .flatMap(one -> refused(one).stream())
                            .distinct()
                            .toList();
            case Type.OBJECT -> {
                String name = type.getInternalName();
                yield own.contains(name) || allowed.allows(name) ? List.of() : List.of(name);
            }
            default -> List.of(); // a primitive type
        };
    }

    /** Notes a method or field that an instruction or a handle names. */
    void member(int line, String owner, String name, String descriptor) {
        if (refusals.isFull()) return;
        boolean may =
                judged.computeIfAbsent(owner, one -> new HashMap<>())
                        .computeIfAbsent(new Member(name, descriptor), one -> mayUse(owner, one));
        if (may) descriptor(line, descriptor);
        else refuse(line, owner, name, descriptor);
    }

    private void refuse(int line, String owner, String name, String descriptor) {
        if (!refusals.isAnswer(line, owner)) {
            if (mayName(owner)) refusals.addMember(line, owner, name, () -> allowed.some(owner));
            else type(line, owner);
        }
        Type type = Type.getType(descriptor);
        Type answer = type.getSort() == Type.METHOD ? type.getReturnType() : type;
        if (answer.getSort() == Type.OBJECT) refusals.addAnswer(line, answer.getInternalName());
    }

    private boolean mayName(String owner) {
        return owner.startsWith("[") || own.contains(owner) || allowed.allows(owner);
    }

    private boolean mayUse(String owner, Member member) {
        if (owner.startsWith("[")) {
            type(0, owner);
            return member.name().equals("clone");
        }
        return own.lineage(owner).stream()
                .anyMatch(
                        one ->
                                own.contains(one)
                                        ? own.shape(one).members().contains(member)
                                        : allowed.allows(one, member.name()));
    }

    /** Checks a constant that ldc loads or a bootstrap gets as an argument. */
    void constant(int line, Object constant) {
        if (constant instanceof Type type) descriptor(line, type.getDescriptor());
        else if (constant instanceof Handle handle)
            member(line, handle.getOwner(), handle.getName(), handle.getDesc());
        else if (constant instanceof ConstantDynamic) refusals.add(line, "dynamic constant");
    }

    void dynamicCall(int line, String descriptor, Handle bootstrap, Object... arguments) {
        String method = bootstrap.getOwner() + "." + bootstrap.getName();
        if (!BOOTSTRAPS.contains(method)) refusals.add(line, method);
        descriptor(line, descriptor);
        for (Object argument : arguments) constant(line, argument);
    }
}
