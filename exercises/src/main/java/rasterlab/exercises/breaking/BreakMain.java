package rasterlab.exercises.breaking;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import rasterlab.exercises.child.Frames;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.judging.MethodsOnInput;
import rasterlab.exercises.judging.MethodsOnInput.MethodResult;
import rasterlab.exercises.score.Phrase;

/**
 * A child that tries methods on inputs, one request at a time, until its parent closes the pipe or
 * kills it. It runs no code of a student's, but methods that may go on without end or take all
 * memory.
 *
 * <p>A request has the topic, an input as UTF-8 bytes, and the names of faulty methods (a count and
 * the names); the answer has the right methods (a count, then name, kind of verdict and what is
 * said of each), then the faulty ones in the same form.
 */
public final class BreakMain {
    private BreakMain() {}

    public static void main(String[] args) throws IOException {
        OutputStream out = System.out;
        // the pipe carries answers alone
        System.setOut(System.err);
        while (true) {
            DataInputStream request =
                    new DataInputStream(
                            new ByteArrayInputStream(
                                    Frames.read(System.in, Wire.MOST_FRAME_BYTES)));
            request.readByte();
            Frames.write(out, answer(request));
        }
    }

    private static byte[] answer(DataInputStream request) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeLong(request.readLong());
        out.writeByte(Wire.DONE);
        String topic = request.readUTF();
        byte[] input = Frames.read(request, Wire.MOST_FRAME_BYTES);
        Set<String> names = new HashSet<>();
        for (int left = request.readInt(); left > 0; left--) names.add(request.readUTF());
        MethodsOnInput<?, ?, ?> methods =
                MethodsOnInput.of(
                        topic, Phrase.of("break.input"), new String(input, StandardCharsets.UTF_8));
        List<MethodResult> right = methods.right();
        write(right, out);
        write(agree(right) ? methods.faulty(names) : new ArrayList<>(), out);
        return bytes.toByteArray();
    }

    private static boolean agree(List<MethodResult> right) {
        return right.stream().noneMatch(MethodResult::failed);
    }

    private static void write(List<MethodResult> all, DataOutputStream out) throws IOException {
        out.writeInt(all.size());
        for (MethodResult one : all) {
            out.writeUTF(one.method());
            out.writeUTF(one.kind().name());
            Frames.write(out, one.message().data().getBytes(StandardCharsets.UTF_8));
        }
    }
}
