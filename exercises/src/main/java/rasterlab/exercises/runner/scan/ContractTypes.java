package rasterlab.exercises.runner.scan;

import java.lang.reflect.Method;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.Set;

/** A contract's types: the interface itself and all of its package that its methods lead to. */
final class ContractTypes {
    private ContractTypes() {}

    /** Follows what public methods take and give back, also within arrays. */
    static Set<Class<?>> of(Class<?> contract) {
        Set<Class<?>> found = new LinkedHashSet<>();
        Deque<Class<?>> open = new ArrayDeque<>();
        open.add(contract);
        while (!open.isEmpty()) {
            Class<?> type = element(open.remove());
            if (!type.getPackageName().equals(contract.getPackageName()) || type.isPrimitive())
                continue;
            if (!found.add(type)) continue;
            for (Method method : type.getMethods()) {
                open.add(method.getReturnType());
                for (Class<?> parameter : method.getParameterTypes()) open.add(parameter);
            }
        }
        return found;
    }

    private static Class<?> element(Class<?> type) {
        Class<?> element = type;
        while (element.isArray()) element = element.getComponentType();
        return element;
    }
}
