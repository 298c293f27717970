package rasterlab.exercises.child;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/** The compiling child: answers pings, compiles one source, ends. */
public final class CompileMain {
    private static final String SAMPLE =
            "public final class Sample implements rasterlab.contract.LineRasterizer {\n"
                    + "  public void draw(int a, int b, int c, int d, rasterlab.contract.Pixels out) {\n"
                    + "    for (int x = Math.min(a, c); x <= c; x++) out.plot(x, b + (d - b) / 2);\n"
                    + "    String text = \"drawn to \" + c; Runnable later = () -> out.plot(c, text.length());\n"
                    + "    later.run(); } }\n";

    private CompileMain() {}

    /**
     * @param args path of the contract's jar, and "warm" to compile a sample before the source
     *     comes
     */
    public static void main(String[] args) throws IOException {
        Requests requests = new Requests(System.in, 0);
        Compiler compiler = new Compiler(args[0]);
        if (args.length > 1 && args[1].equals("warm")) compiler.compile(SAMPLE);
        OutputStream out = System.out;
        while (!answer(compiler, requests.next(), out)) {
            // a ping: wait for the source
        }
    }

    /** Answers one request; true when it was the source. */
    private static boolean answer(Compiler compiler, DataInputStream in, OutputStream out)
            throws IOException {
        int operation = in.readByte();
        long nonce = in.readLong();
        if (operation == Wire.PING) {
            Frames.write(out, Reply.of(nonce, new byte[] {Wire.DONE}));
            return false;
        }
        String source = new String(Frames.read(in, Wire.MOST_FRAME_BYTES), StandardCharsets.UTF_8);
        Frames.write(out, Reply.of(nonce, compiler.compile(source)));
        return true;
    }
}
