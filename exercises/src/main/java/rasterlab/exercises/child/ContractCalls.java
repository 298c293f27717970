package rasterlab.exercises.child;

import java.io.IOException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/** The calls of all methods that a contract has implemented; parent and child number them alike. */
public final class ContractCalls {
    private final Class<?> contract;
    private final List<ContractCall> all = new ArrayList<>();

    private ContractCalls(Class<?> contract) {
        this.contract = contract;
        Stream.of(contract.getMethods())
                .filter(one -> Modifier.isAbstract(one.getModifiers()))
                .sorted(Comparator.comparing(Method::toString))
                .forEach(one -> all.add(ContractCall.of(all.size(), one)));
    }

    /**
     * The calls of a contract.
     *
     * @throws IllegalArgumentException if it has no method without a body, or one that takes or
     *     returns what cannot be sent
     */
    public static ContractCalls of(Class<?> contract) {
        var calls = new ContractCalls(contract);
        if (calls.all.isEmpty())
            throw new IllegalArgumentException(
                    contract.getSimpleName() + " must have a method to implement");
        return calls;
    }

    public Class<?> contract() {
        return contract;
    }

    /** One for each method, by its number. */
    public List<ContractCall> all() {
        return List.copyOf(all);
    }

    /**
     * The call of a method of the contract.
     *
     * @throws IllegalArgumentException if it is none to implement
     */
    public ContractCall of(Method method) {
        return all.stream()
                .filter(one -> one.method().equals(method))
                .findFirst()
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        method + " is no method of " + contract.getName()));
    }

    ContractCall numbered(int number) throws IOException {
        if (number < 0 || number >= all.size())
            throw new IOException("method " + number + " of " + all.size());
        return all.get(number);
    }
}
