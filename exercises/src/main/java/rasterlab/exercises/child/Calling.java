package rasterlab.exercises.child;

import static java.lang.invoke.MethodType.methodType;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodHandles.Lookup;
import java.lang.reflect.Method;

/** Calls the method of a contract that the student's class implements. */
abstract class Calling {
    /**
     * A copy of {@link ConstantCalling} of which the contract's method is a constant.
     *
     * @param method public, of a public interface
     */
    static Calling of(Method method) {
        try {
            MethodHandle handle =
                    MethodHandles.publicLookup()
                            .unreflect(method)
                            .asSpreader(Object[].class, method.getParameterCount())
                            .asType(methodType(Object.class, Object.class, Object[].class));
            Lookup copy =
                    MethodHandles.lookup().defineHiddenClassWithClassData(bytes(), handle, true);
            return (Calling) copy.lookupClass().getDeclaredConstructor().newInstance();
        } catch (ReflectiveOperationException e) {
            throw new AssertionError("a contract's method can be called: " + method, e);
        }
    }

    private static byte[] bytes() {
        Class<?> type = ConstantCalling.class;
        try (InputStream in = type.getResourceAsStream(type.getSimpleName() + ".class")) {
            return in.readAllBytes();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    abstract Object call(Object student, Object[] given) throws Throwable;

    /** The loop that is timed. */
    abstract void callEach(Object student, Object[][] given, Object[] returned) throws Throwable;
}
