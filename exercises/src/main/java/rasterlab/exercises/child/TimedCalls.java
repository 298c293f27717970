package rasterlab.exercises.child;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;

/** Calls that are timed together: what each is given and what comes of it. */
final class TimedCalls {
    /** Numbers beside the answers that are told in full. */
    private static final int ROOM = 256;

    private final ContractCall[] methods;
    private final Calling[] by;
    private final Object[][] given;
    private final byte[][] before;
    private final Object[] returned;
    private final int mostBytes;
    private final int from;
    private final int to;

    /** Reads the payload of {@link Wire#TIME}. */
    TimedCalls(ContractCalls contract, List<Calling> callings, DataInputStream in)
            throws IOException {
        int calls = in.readInt();
        int most = Math.min(in.readInt(), Wire.MOST_ITEMS);
        mostBytes = Math.min(in.readInt(), Wire.MOST_ANSWER_BYTES);
        int room = in.readInt();
        from = in.readInt();
        to = in.readInt();
        methods = new ContractCall[calls];
        by = new Calling[calls];
        given = new Object[calls][];
        before = new byte[calls][];
        returned = new Object[calls];
        for (int i = 0; i < calls; i++) {
            methods[i] = contract.numbered(in.readInt());
            by[i] = callings.get(methods[i].number());
            given[i] = methods[i].readArguments(in, most, room);
            if (i >= from && i < to) before[i] = methods[i].values(given[i]);
        }
    }

    void run(Object student) throws Throwable {
        Calling.callEach(by, student, given, returned);
    }

    /** Whether one went on beyond the most items and was stopped. */
    boolean wasStopped() {
        return Stream.of(given)
                .flatMap(Stream::of)
                .anyMatch(one -> one instanceof SinkSheet sheet && sheet.full());
    }

    /**
     * Writes the number of items, their sum, the number of printed bytes and what came of the calls
     * that are told in full.
     *
     * @throws BoundedBytes.Beyond if that is longer than what is taken
     */
    void writeTo(DataOutputStream out, long printed) throws IOException {
        ItemSum sum = new ItemSum();
        for (int i = 0; i < methods.length; i++)
            methods[i].addTo(sum, given[i], returned[i], mostBytes);
        out.writeLong(sum.count());
        out.writeLong(sum.sum());
        out.writeLong(printed);
        ArrayAliases arrays = new ArrayAliases();
        int left = Wire.MOST_ANSWER_BYTES - ROOM;
        for (int i = from; i < to; i++) {
            byte[] answer =
                    methods[i].answer(
                            before[i],
                            arrays.before(methods[i], given[i]),
                            given[i],
                            returned[i],
                            Math.min(left, mostBytes));
            arrays.after(methods[i], returned[i]);
            left -= answer.length + Integer.BYTES;
            Frames.write(out, answer);
        }
    }
}
