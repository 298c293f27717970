package rasterlab.exercises.child;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.util.List;
import java.util.stream.Stream;

/** Calls methods by way of the wire, with both of its ends in this process. */
final class CalledHere {
    static final int MOST = 20_000;

    private CalledHere() {}

    /** Answers a call of a method of the contract. */
    interface Answering {
        Object answer(ContractCall call, Object implementation, Object[] given) throws Throwable;
    }

    @SuppressWarnings("unchecked") // the proxy is of the contract
    static <C> C remote(ContractCalls contract, C implementation, Answering answering) {
        Class<?> type = contract.contract();
        InvocationHandler handler =
                (proxy, method, given) ->
                        method.isDefault()
                                ? method.invoke(implementation, given)
                                : answering.answer(contract.of(method), implementation, given);
        return (C) Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[] {type}, handler);
    }

    /** Calls as a child does for one input after the other. */
    static Answering calling() {
        var there = new ArrayAliases();
        var here = new ArrayAliases();
        return (call, implementation, given) ->
                replayed(call, called(call, implementation, given, there), given, here);
    }

    static byte[] called(
            ContractCall call, Object implementation, Object[] given, ArrayAliases arrays)
            throws Throwable {
        Object[] there = call.readArguments(in(sent(call, given)), MOST + 1, 10);
        byte[] before = call.values(there);
        List<Object> held = arrays.before(call, there);
        Object returned = null;
        try {
            returned = call.invoke(implementation, there);
        } catch (Error stopped) {
            if (Stream.of(there).noneMatch(one -> one instanceof SinkSheet sheet && sheet.full()))
                throw stopped;
        }
        byte[] answer = call.answer(before, held, there, returned, Integer.MAX_VALUE);
        arrays.after(call, returned);
        return answer;
    }

    static byte[] sent(ContractCall call, Object[] given) throws IOException {
        var sent = new ByteArrayOutputStream();
        call.writeArguments(given, new DataOutputStream(sent));
        return sent.toByteArray();
    }

    static Object replayed(ContractCall call, byte[] answer, Object[] given, ArrayAliases arrays)
            throws IOException {
        DataInputStream in = in(answer);
        Object value = call.replay(in, given, arrays).value();
        assertEquals(0, in.available(), "bytes are left over");
        return value;
    }

    static DataInputStream in(byte[] bytes) {
        return new DataInputStream(new ByteArrayInputStream(bytes));
    }
}
