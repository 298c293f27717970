package rasterlab.exercises.child;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;

/** A right method, whose answers are written down as a child would, so that they are measured. */
public final class MeasuredMethod implements InvocationHandler {
    private final ContractCalls contract;
    private final Object right;
    private final int items;
    private final ArrayAliases arrays = new ArrayAliases();
    private int longest;
    private long all;

    /**
     * @param right a method of the contract
     * @param items that a sink takes
     */
    public MeasuredMethod(ContractCalls contract, Object right, int items) {
        this.contract = contract;
        this.right = right;
        this.items = items;
    }

    /** The method to be called. */
    public Object proxy() {
        Class<?> type = contract.contract();
        return Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[] {type}, this);
    }

    /** Bytes of the longest answer so far. */
    public int longest() {
        return longest;
    }

    /** Bytes of all answers so far, each as a frame. */
    public long all() {
        return all;
    }

    @Override
    public Object invoke(Object proxy, Method method, Object[] given) throws Throwable {
        if (method.isDefault()) return InvocationHandler.invokeDefault(proxy, method, given);
        ContractCall call = contract.of(method);
        byte[] answer = call.answered(right, given, items + 1);
        longest = Math.max(longest, answer.length);
        all += answer.length + Integer.BYTES;
        var in = new DataInputStream(new ByteArrayInputStream(answer));
        return call.replay(in, given, arrays).value();
    }
}
