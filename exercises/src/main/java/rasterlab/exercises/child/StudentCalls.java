package rasterlab.exercises.child;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.contract.LineRasterizer;

/** Answers the parent's requests by calling the student's object. */
final class StudentCalls {
    private final OutputStream parent;
    private final CappedOutput printed;
    private Object student;

    StudentCalls(OutputStream parent, CappedOutput printed) {
        this.parent = parent;
        this.printed = printed;
    }

    void answer(DataInputStream request) throws IOException {
        int operation = request.readByte();
        long nonce = request.readLong();
        switch (operation) {
            case Wire.PING -> send(nonce, new byte[] {Wire.DONE});
            case Wire.LOAD -> load(nonce, request);
            case Wire.DRAW_LINE -> drawLine(nonce, request);
            case Wire.TIME_LINES -> timeLines(nonce, request);
            default -> throw new IOException("unknown operation " + operation);
        }
    }

    private void load(long nonce, DataInputStream request) throws IOException {
        String name = request.readUTF();
        Map<String, byte[]> classes = new HashMap<>();
        for (int left = request.readInt(); left > 0; left--)
            classes.put(request.readUTF(), Frames.read(request, Wire.MOST_CLASS_BYTES));
        try {
            Class<?> type = Class.forName(name, true, new StudentLoader(classes));
            student = type.getConstructor().newInstance();
        } catch (ReflectiveOperationException e) {
            Throwable cause = e.getCause();
            if (cause == null) send(nonce, new byte[] {Wire.NOT_LOADABLE});
            else threw(nonce, cause);
            return;
        } catch (Throwable e) {
            threw(nonce, e);
            return;
        }
        send(nonce, new byte[] {Wire.DONE});
    }

    private void drawLine(long nonce, DataInputStream in) throws IOException {
        LineRasterizer method = (LineRasterizer) student;
        int x0 = in.readInt();
        int y0 = in.readInt();
        int x1 = in.readInt();
        int y1 = in.readInt();
        Sheet pixels = new Sheet(Math.min(in.readInt(), Wire.MOST_PIXELS));
        try {
            method.draw(x0, y0, x1, y1, pixels);
        } catch (Throwable e) {
            if (!pixels.full()) {
                threw(nonce, e);
                return;
            }
        }
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(body);
        out.writeByte(pixels.full() ? Wire.CUT : Wire.DONE);
        pixels.writeTo(out);
        out.writeUTF(printed.take());
        send(nonce, body.toByteArray());
    }

    private void timeLines(long nonce, DataInputStream in) throws IOException {
        LineRasterizer method = (LineRasterizer) student;
        int[] ends = new int[4 * in.readInt()];
        int most = in.readInt();
        int room = in.readInt();
        for (int i = 0; i < ends.length; i++) ends[i] = in.readInt();
        Sheet[] sheets = new Sheet[ends.length / 4];
        for (int i = 0; i < sheets.length; i++) sheets[i] = new Sheet(most, room);
        printed.drop();
        long start = System.nanoTime();
        try {
            for (int i = 0; i < ends.length; i += 4)
                method.draw(ends[i], ends[i + 1], ends[i + 2], ends[i + 3], sheets[i >> 2]);
        } catch (Throwable e) {
            if (Stream.of(sheets).noneMatch(Sheet::full)) {
                printed.keep();
                threw(nonce, e);
                return;
            }
        }
        long nanos = System.nanoTime() - start;
        PixelSum pixels = new PixelSum();
        for (Sheet sheet : sheets) sheet.addTo(pixels);
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(body);
        out.writeByte(Wire.DONE);
        out.writeLong(nanos);
        out.writeLong(pixels.count());
        out.writeLong(pixels.sum());
        out.writeLong(printed.keep());
        send(nonce, body.toByteArray());
    }

    /** Sends the class first: the student's getMessage may loop, or never fit in memory. */
    private void threw(long nonce, Throwable error) throws IOException {
        Thrown thrown = Thrown.of(error);
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(body);
        out.writeByte(Wire.THREW);
        out.writeUTF(Wire.cut(thrown.type()));
        send(nonce, body.toByteArray());
        body.reset();
        out.writeByte(Wire.MESSAGE);
        out.writeUTF(Wire.cut(thrown.message()));
        out.writeUTF(printed.take());
        out.writeInt(thrown.line());
        send(nonce, body.toByteArray());
    }

    private void send(long nonce, byte[] body) throws IOException {
        Frames.write(parent, Reply.of(nonce, body));
    }
}
