package rasterlab.exercises.runner;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Optional;
import rasterlab.exercises.child.ArrayAliases;
import rasterlab.exercises.child.ContractCall;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.child.Values;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Answer.CallEnding;
import rasterlab.exercises.score.Message;

/**
 * A student's method as an object of its contract: whoever calls it has the child called, and finds
 * in sinks and arrays what the child's method sent and wrote there.
 */
final class StudentMethodProxy implements InvocationHandler {
    /** Ends what called the method: there is no answer to go on with. */
    static final class Unanswered extends Error {
        private static final long serialVersionUID = 1L;

        Unanswered(Throwable cause) {
            super("the child does not answer", cause, false, false);
        }
    }

    /** One call's answer, as the child sent it. */
    record CallReply(int status, byte[] answer, String printed) {}

    /** Sends a call to the child. */
    @FunctionalInterface
    interface Sending {
        CallReply send(ContractCall method, Object[] arguments)
                throws ChildLost, InterruptedException, MethodException;
    }

    /** Carries what the method threw. */
    static final class MethodException extends Exception {
        private static final long serialVersionUID = 1L;
        private final transient Answer answer;

        MethodException(Answer answer) {
            super(answer.exception(), null, false, false);
            this.answer = answer;
        }

        Answer answer() {
            return answer;
        }
    }

    private final ContractCalls contract;
    private final Sending sending;
    private final MessageDigest told = sha256();
    private final ArrayAliases arrays = new ArrayAliases();
    private final StringBuilder printed = new StringBuilder();
    private long items;
    private boolean asked;
    private Answer ended;

    StudentMethodProxy(ContractCalls contract, Sending sending) {
        this.contract = contract;
        this.sending = sending;
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java has SHA-256", e);
        }
    }

    /** The student's method, to be called as any other. */
    Object method() {
        return proxy(contract, this);
    }

    static Object proxy(ContractCalls contract, InvocationHandler handler) {
        Class<?> type = contract.contract();
        return Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[] {type}, handler);
    }

    /** Whether the child answered a call; what fails before is a fault of ours. */
    boolean asked() {
        return asked;
    }

    @Override
    public Object invoke(Object proxy, Method method, Object[] arguments) throws Throwable {
        if (method.isDefault()) return InvocationHandler.invokeDefault(proxy, method, arguments);
        if (method.getDeclaringClass() == Object.class) return method.invoke(this, arguments);
        try {
            ContractCall call = contract.of(method);
            CallReply reply = sending.send(call, arguments);
            asked = true;
            return replayed(call, reply, arguments);
        } catch (MethodException threw) {
            ended = threw.answer;
            throw new Unanswered(threw);
        } catch (ChildLost | InterruptedException lost) {
            throw new Unanswered(lost);
        }
    }

    private Object replayed(ContractCall call, CallReply reply, Object[] arguments)
            throws ChildLost {
        printed.append(reply.printed());
        told.update(reply.answer());
        if (reply.status() == Wire.TOO_LONG) throw ended(CallEnding.TOO_LONG);
        ContractCall.Done done;
        try {
            var in = new DataInputStream(new ByteArrayInputStream(reply.answer()));
            done = call.replay(in, arguments, arrays);
        } catch (IOException noAnswer) {
            throw new Unanswered(ChildLost.protocol(noAnswer));
        }
        items += done.items();
        if (done.spoilt()) throw ended(CallEnding.OVERWROTE);
        if (call.returnsValue() && done.value() == null) throw ended(CallEnding.NULL);
        if (Values.hasNull(done.value())) {
            ended = unusable(Message.of("answer.null-within"));
            throw new Unanswered(null);
        }
        if (reply.status() == Wire.CUT) throw ended(CallEnding.CUT);
        return done.value();
    }

    private Unanswered ended(CallEnding ending) {
        ended = without(ending, "");
        return new Unanswered(null);
    }

    /** The answer after which nothing more was asked. */
    Optional<Answer> ended() {
        return Optional.ofNullable(ended);
    }

    /**
     * An answer with an output; one that was cut has items, though its last call's are not counted.
     */
    Answer with(CallEnding ending, Object output) {
        long known = ending == CallEnding.CUT ? Math.max(1, items) : items;
        return Answer.with(ending, output, known, digest(), Wire.cut(printed.toString()));
    }

    Answer without(CallEnding ending, String message) {
        return Answer.without(ending, digest(), Wire.cut(message), Wire.cut(printed.toString()));
    }

    Answer unusable(Message said) {
        return Answer.unusable(digest(), said, Wire.cut(printed.toString()));
    }

    private String digest() {
        return HexFormat.of().formatHex(told.digest());
    }
}
