package rasterlab.exercises.child;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Answers the parent's requests by calling the student's object. */
final class StudentCalls {
    private final OutputStream parent;
    private final CappedOutput printed;
    private final ArrayAliases arrays = new ArrayAliases();
    private Object student;
    private ContractCalls contract;
    private List<Calling> callings = List.of();

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
            case Wire.CALL -> call(nonce, request);
            case Wire.TIME -> time(nonce, request);
            default -> throw new IOException("unknown operation " + operation);
        }
    }

    private void load(long nonce, DataInputStream request) throws IOException {
        contract = contract(request.readUTF());
        callings = new ArrayList<>();
        for (int left = contract.all().size(); left > 0; left--)
            callings.add(Calling.of(Frames.read(request, Wire.MOST_CLASS_BYTES)));
        String name = request.readUTF();
        Map<String, byte[]> classes = new HashMap<>();
        for (int left = request.readInt(); left > 0; left--)
            classes.put(request.readUTF(), Frames.read(request, Wire.MOST_CLASS_BYTES));
        try {
            Class<?> type = Class.forName(name, true, new StudentLoader(classes));
            student = contract.contract().cast(type.getConstructor().newInstance());
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

    private static ContractCalls contract(String name) throws IOException {
        try {
            return ContractCalls.of(Class.forName(name));
        } catch (ClassNotFoundException e) {
            throw new IOException("no contract " + name, e);
        }
    }

    private void call(long nonce, DataInputStream in) throws IOException {
        if (in.readBoolean()) arrays.forget();
        int most = Math.min(in.readInt(), Wire.MOST_ITEMS);
        int mostBytes = Math.min(in.readInt(), Wire.MOST_ANSWER_BYTES);
        ContractCall method = contract.numbered(in.readInt());
        Object[] given = method.readArguments(in, most, Math.min(most, SinkSheet.USUAL));
        byte[] before = method.values(given);
        List<Object> held = arrays.before(method, given);
        Object returned = null;
        try {
            returned = callings.get(method.number()).call(student, given);
        } catch (Throwable e) {
            if (!SinkSheet.isAnyFull(given)) {
                threw(nonce, e);
                return;
            }
        }
        int status = SinkSheet.isAnyFull(given) ? Wire.CUT : Wire.DONE;
        byte[] answer = new byte[0];
        try {
            answer = method.answer(before, held, given, returned, mostBytes);
            arrays.after(method, returned);
        } catch (BoundedBytes.Beyond tooLong) {
            status = Wire.TOO_LONG;
        }
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(body);
        out.writeByte(status);
        Frames.write(out, answer);
        out.writeUTF(printed.take());
        send(nonce, body.toByteArray());
    }

    private void time(long nonce, DataInputStream in) throws IOException {
        TimedCalls calls = new TimedCalls(contract, callings, in);
        printed.drop();
        long start = System.nanoTime();
        try {
            calls.run(student);
        } catch (Throwable e) {
            printed.keep();
            if (calls.wasStopped()) send(nonce, new byte[] {Wire.CUT});
            else threw(nonce, e);
            return;
        }
        long nanos = System.nanoTime() - start;
        long dropped = printed.keep();
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        try {
            DataOutputStream out = new DataOutputStream(body);
            out.writeByte(Wire.DONE);
            out.writeLong(nanos);
            calls.writeTo(out, dropped);
        } catch (BoundedBytes.Beyond tooLong) {
            send(nonce, new byte[] {Wire.TOO_LONG});
            return;
        }
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
