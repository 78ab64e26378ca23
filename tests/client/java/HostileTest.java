import geminga.Identity;
import geminga.Offer;
import geminga.Request;
import geminga.protocol.Addresses;
import geminga.protocol.Frame;
import geminga.protocol.FrameReader;
import geminga.protocol.Handshake;
import geminga.protocol.Life;
import geminga.protocol.Limits;
import geminga.protocol.LineException;
import geminga.protocol.LineReader;
import geminga.protocol.Reply;
import geminga.protocol.Statement;
import geminga.protocol.Told;
import geminga.protocol.WireFrame;
import geminga.protocol.Words;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Input from outside is read within limits and never breaks anything. */
final class HostileTest {
    private static final long LIFE = 0x0123456789ABCDEFL;

    static void aLineHasSoManyOctetsAndNoMore() throws Exception {
        String head = "5 pub create x=";
        for (int size : new int[] {Statement.MAX_OCTETS - 1, Statement.MAX_OCTETS}) {
            String line = head + "y".repeat(size - head.length());
            Check.equal(line, Statement.read(line).write());
            Check.equal(line, new LineReader().next(octets(line + "\r\n")));
        }
        String tooLong = head + "y".repeat(Statement.MAX_OCTETS + 1 - head.length());
        Check.fails(LineException.class, () -> Statement.read(tooLong));
        LineReader lines = new LineReader();
        ByteBuffer octets = octets(tooLong + "z\nnext\n");
        Check.equal("next", lines.next(octets));
        Check.equal(1L, lines.skipped());
    }

    static void aLineHasSoManyParametersAndNoMore() throws Exception {
        for (int count = Statement.MAX_PARAMETERS - 1; count <= Statement.MAX_PARAMETERS + 1; ++count) {
            StringBuilder line = new StringBuilder("5 pub create");
            for (int i = 0; i < count; ++i) line.append(" k").append(i).append("=1");
            if (count <= Statement.MAX_PARAMETERS) {
                Check.equal(count, Statement.read(line.toString()).parameters().size());
            } else {
                Check.fails(LineException.class, () -> Statement.read(line.toString()));
            }
        }
    }

    static void linesThatComeInPiecesAreWhole() {
        LineReader lines = new LineReader();
        List<String> found = new ArrayList<>();
        for (byte octet : "0 msg hello\r\n\n5 pub add name=\u00d6l\n".getBytes(StandardCharsets.UTF_8)) {
            String line = lines.next(ByteBuffer.wrap(new byte[] {octet}));
            if (line != null) found.add(line);
        }
        Check.equal(List.of("0 msg hello", "", "5 pub add name=\u00d6l"), found);
    }

    static void bentLinesAreReadOrRefused() throws Exception {
        Random chance = Check.chance();
        List<String> seeds = new ArrayList<>(Check.block("events"));
        seeds.addAll(Check.block("requests"));
        for (int i = 0; i < 20_000; ++i) {
            StringBuilder line = new StringBuilder(seeds.get(chance.nextInt(seeds.size())));
            for (int bends = chance.nextInt(4); bends >= 0; --bends) {
                int at = chance.nextInt(line.length());
                if (chance.nextBoolean()) {
                    line.setCharAt(at, (char) chance.nextInt(128));
                } else {
                    line.deleteCharAt(at);
                }
            }
            try {
                String text = line.toString();
                if (Reply.read(text) != null) continue;
                Statement statement = Statement.read(text);
                Check.equal(statement, Statement.read(statement.write()));
                Told told = Told.read(statement);
                if (told != null) Check.equal(statement.parameters().size(), told.write().parameters().size());
            } catch (LineException isRefused) {
                Check.that(!isRefused.getMessage().isEmpty(), "an error says what is wrong");
            }
        }
    }

    static void anEventWithoutWhatItMustSayIsRefused() throws Exception {
        String whole = "7 pub add service=5e6f7a8b/2/1 text=x degree=exact distance=0 mode=oto port=1 protocol=udp priority=0";
        Check.equal("5e6f7a8b/2/1", Told.read(Statement.read(whole)).word());
        for (String[] change : new String[][] {{"service=5e6f7a8b/2/1 ", ""}, {"text=x", "text=\"\""}, {"degree=exact", "degree=best"}, {"mode=oto", "mode=x"},
                {"port=1", "port=65536"}, {"port=1", "port=-1"}, {"distance=0", "distance=x"}, {"text=x ", ""}, {"text=x", "id=4294967296"}}) {
            Check.fails(LineException.class, () -> Told.read(Statement.read(whole.replace(change[0], change[1]))));
        }
        Check.equal(null, Told.read(Statement.read("7 pub explode x=1")));
        Check.equal(null, Told.read(Statement.read("7 query add x=1")));
    }

    static void aLifeIsSixteenLowerCaseDigitsAndNotZero() {
        Check.equal(LIFE, Life.read("0123456789abcdef"));
        Check.equal(-1L, Life.read("ffffffffffffffff"));
        for (String text : new String[] {null, "", "0000000000000000", "0123456789ABCDEF", "0123456789abcde", "0123456789abcdef0", "+123456789abcdef", "0x23456789abcdef"}) {
            Check.equal(0L, Life.read(text));
        }
    }

    static void aDatagramHasSoManyOctetsAndNoMore() {
        for (int size : new int[] {0, Limits.UDP_MESSAGE - 1, Limits.UDP_MESSAGE}) {
            Check.equal(size, Frame.ofDatagram(ByteBuffer.wrap(message(size))).payload().length);
        }
        Check.equal(null, Frame.ofDatagram(ByteBuffer.wrap(message(Limits.UDP_MESSAGE + 1))));
    }

    static void aFrameOfAConnectionHasSoManyOctetsAndNoMore() {
        for (int size : new int[] {Limits.TCP_MESSAGE - 1, Limits.TCP_MESSAGE}) {
            FrameReader frames = new FrameReader(Limits.TCP_MESSAGE);
            Check.equal(size, frames.next(ByteBuffer.wrap(message(size))).size());
        }
        FrameReader frames = new FrameReader(Limits.TCP_MESSAGE);
        Check.equal(null, frames.next(ByteBuffer.wrap(message(Limits.TCP_MESSAGE + 1))));
        Check.that(frames.isBroken(), "too large");
        Check.equal(null, frames.next(ByteBuffer.wrap(message(1))));
    }

    static void framesThatComeInPiecesAreWhole() {
        FrameReader frames = new FrameReader(Limits.TCP_MESSAGE);
        ByteBuffer octets = ByteBuffer.allocate(400_000).put(Frame.hello(LIFE, new Handshake(1, 2, 3)).write()).put(message(300_000)).put(message(0)).put(Frame.end(LIFE, 2).write()).flip();
        List<String> found = new ArrayList<>();
        while (octets.hasRemaining()) {
            ByteBuffer piece = octets.slice(octets.position(), Math.min(octets.remaining(), 7));
            octets.position(octets.position() + piece.remaining());
            for (WireFrame frame = frames.next(piece); frame != null; frame = frames.next(piece)) found.add(frame.kind() + " " + frame.size());
        }
        Check.equal(List.of("HELLO 24", "MESSAGE 300000", "MESSAGE 0", "END 0"), found);
    }

    static void randomOctetsAreNoFrames() {
        Random chance = Check.chance();
        for (int i = 0; i < 20_000; ++i) {
            boolean isFrame = chance.nextBoolean();
            byte[] octets = isFrame ? message(chance.nextInt(40)) : new byte[chance.nextInt(60)];
            if (!isFrame) chance.nextBytes(octets);
            for (int bends = chance.nextInt(3); bends > 0 && octets.length > 0; --bends) octets[chance.nextInt(octets.length)] = (byte) chance.nextInt();
            Frame frame = Frame.ofDatagram(ByteBuffer.wrap(octets));
            if (frame != null) Check.equal(ByteBuffer.wrap(octets), ByteBuffer.wrap(frame.write()));
            FrameReader frames = new FrameReader(64);
            ByteBuffer rest = ByteBuffer.wrap(octets);
            while (frames.next(rest) != null) { }
        }
    }

    static void namesAreNeverLookedUp() {
        for (String text : List.of("robot2", "localhost", "1.2.3", "1.2.3.4.5", "256.1.1.1", "", "[::1]", "::g", "1.2.3.4%lo", "%lo", "::1%")) Check.that(!Addresses.isNumeric(text), text);
        for (String text : List.of("10.0.0.2", "::1", "fe80::1%anything0", "239.1.1.1", "::ffff:10.0.0.1")) Check.that(Addresses.isNumeric(text), text);
    }

    static void whatIsStatedHasLimits() throws Exception {
        Offer offer = Offer.of(geminga.Mode.ONE_TO_ONE, Identity.text("x".repeat(255)));
        Check.fails(IllegalArgumentException.class, () -> Identity.text("x".repeat(256)));
        Check.fails(IllegalArgumentException.class, () -> Identity.number(1L << 32));
        Check.fails(IllegalArgumentException.class, () -> Identity.concept("x".repeat(1025)));
        offer.attribute("n".repeat(Words.MAX_NAME), "v".repeat(Words.MAX_VALUE));
        Check.fails(IllegalArgumentException.class, () -> offer.attribute("n".repeat(Words.MAX_NAME + 1), "v"));
        Check.fails(IllegalArgumentException.class, () -> offer.attribute("n", "v".repeat(Words.MAX_VALUE + 1)));
        Check.fails(IllegalArgumentException.class, () -> offer.attribute("", "v"));
        Offer full = offer;
        for (int i = 0; i < Words.MAX_ATTRIBUTES; ++i) full = full.attribute("n" + i, "v");
        Offer all = full;
        Check.fails(IllegalArgumentException.class, () -> all.attribute("more", "v"));
        Check.fails(IllegalArgumentException.class, () -> offer.attribute("n", "\u0001"));
        Check.fails(IllegalArgumentException.class, () -> offer.scope("\u007f"));
        Check.fails(IllegalArgumentException.class, () -> geminga.Options.named("\u0000"));
        Check.fails(IllegalArgumentException.class, () -> offer.port(65536));
        Check.fails(IllegalArgumentException.class, () -> offer.address("robot2"));
        Check.fails(IllegalArgumentException.class, () -> Request.read("mode=oto text=a concept=b"));
        Check.fails(IllegalArgumentException.class, () -> new Statement(1, "pub", "create", List.of(new geminga.protocol.Parameter("x", "\u0001"))).write());
    }

    private static byte[] message(int size) {
        return new Frame(Frame.Kind.MESSAGE, LIFE, 1, new byte[size]).write();
    }

    private static ByteBuffer octets(String text) {
        return ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
    }
}
