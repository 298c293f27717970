package rasterlab.exercises.child;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/**
 * The running child: loads one student's class and calls it as often as the parent asks.
 *
 * <p>The pipes to the parent are taken aside before any of the student's code runs; what it prints
 * goes elsewhere.
 */
public final class RunMain {
    private RunMain() {}

    public static void main(String[] args) {
        Requests requests = new Requests(System.in, Wire.EXIT_PROTOCOL);
        OutputStream out = System.out;
        CappedOutput printed = new CappedOutput();
        PrintStream print = new PrintStream(printed, true, StandardCharsets.UTF_8);
        System.setIn(InputStream.nullInputStream());
        System.setOut(print);
        System.setErr(print);
        StudentCalls calls = new StudentCalls(out, printed);
        try {
            while (true) calls.answer(requests.next());
        } catch (IOException parentHasGone) {
            Runtime.getRuntime().halt(Wire.EXIT_PROTOCOL);
        }
    }
}
