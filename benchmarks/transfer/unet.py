"""A small U-Net and its training, the same for every set. PyTorch 1.13 and newer, processor or GPU."""

import contextlib
import math

import torch
from torch import nn
from torch.nn import functional as F


def block(inputs, outputs):
    return nn.Sequential(
        *(
            layer
            for width in (inputs, outputs)
            for layer in (
                nn.Conv2d(width, outputs, 3, padding=1, bias=False),
                nn.BatchNorm2d(outputs),
                nn.ReLU(inplace=True),
            )
        )
    )


class UNet(nn.Module):
    """(n, 3, h, w), 0 … 1, to (n, 1, h, w) logits; h and w multiples of 8. 1.1 million weights at 24
    channels."""

    def __init__(self, channels=24):
        super().__init__()
        widths = [channels * 2**k for k in range(4)]
        self.down = nn.ModuleList(block(a, b) for a, b in zip([3] + widths, widths))
        self.up = nn.ModuleList(
            block(a + b, b) for a, b in zip(widths[:0:-1], widths[-2::-1])
        )
        self.last = nn.Conv2d(channels, 1, 1)

    def forward(self, x):
        x, kept = (x - 0.5) / 0.25, []
        for k, layer in enumerate(self.down):
            x = layer(x if k == 0 else F.max_pool2d(x, 2))
            kept.append(x)
        kept.pop()
        for layer in self.up:
            x = F.interpolate(x, scale_factor=2.0, mode="nearest")
            x = layer(torch.cat([x, kept.pop()], dim=1))
        return self.last(x)


def camera_faults(x, random):
    """Turns, gain, contrast, tint, blur and noise, drawn per picture: what plans leave to the camera,
    added to every set alike. `x` is (n, 3, h, w), 0 … 1."""
    n = len(x)

    def draw(low, high, *shape):
        return low + (high - low) * torch.rand(n, *shape, 1, 1, generator=random, device=x.device)

    x = x.clamp(1e-3, 1) ** torch.exp(draw(-0.5, 0.5, 1))
    x = (x - 0.5) * draw(0.6, 1.3, 1) + 0.5 + draw(-0.2, 0.2, 1)
    x = x * draw(0.85, 1.15, 3)
    x = blurred(x, draw(0.0, 1.4, 1))
    noise = torch.randn(x.shape, generator=random, device=x.device)
    return (x + draw(0.0, 0.04, 1) * noise).clamp(0, 1)


def blurred(x, deviation):
    """Gaussian blur, a deviation in pixels for each picture, up to 1.4."""
    n, c, h, w = x.shape
    at = torch.arange(-4, 5, device=x.device, dtype=x.dtype)
    taps = torch.exp(-(at**2) / (2 * deviation.reshape(n, 1).clamp(min=0.1) ** 2))
    taps = (taps / taps.sum(dim=1, keepdim=True)).repeat_interleave(c, dim=0)
    x = F.pad(x.reshape(1, n * c, h, w), (4, 4, 4, 4), mode="replicate")
    x = F.conv2d(x, taps.reshape(n * c, 1, 1, 9), groups=n * c)
    x = F.conv2d(x, taps.reshape(n * c, 1, 9, 1), groups=n * c)
    return x.reshape(n, c, h, w)


def turned(x, y, random):
    """Each batch mirrored or turned in one of eight ways."""
    way = int(torch.randint(8, (1,), generator=random, device=x.device))
    if way & 4:
        x, y = x.flip(3), y.flip(3)
    return torch.rot90(x, way & 3, (2, 3)), torch.rot90(y, way & 3, (2, 3))


def loss_of(logits, truth):
    """Cross entropy and one less Dice, of the batch."""
    found = torch.sigmoid(logits)
    dice = (2 * (found * truth).sum() + 1) / (found.sum() + truth.sum() + 1)
    return F.binary_cross_entropy_with_logits(logits, truth) + 1 - dice


def train(sources, seed, steps, batch, device, channels=24):
    """A network trained for so many steps. `sources` are pairs (pictures (n, 3, h, w) uint8, masks
    (n, 1, h, w) bool) on the device, from each of which comes an equal part of every batch."""
    torch.manual_seed(seed)
    torch.backends.cudnn.benchmark = True  # all batches have one shape
    random = torch.Generator(device=device).manual_seed(seed)
    net = UNet(channels).to(device)
    if device != "cpu":
        net = net.to(memory_format=torch.channels_last)
    best = torch.optim.AdamW(net.parameters(), lr=2e-3, weight_decay=1e-3)
    rate = torch.optim.lr_scheduler.LambdaLR(best, lambda k: schedule(k / steps))
    net.train()
    for _ in range(steps):
        x, y = drawn(sources, batch, random, device)
        x, y = turned(x.float() / 255, y.float(), random)
        with faster(device):
            logits = net(camera_faults(x, random))
        loss = loss_of(logits.float(), y)
        best.zero_grad(set_to_none=True)
        loss.backward()
        best.step()
        rate.step()
    return net


def faster(device):
    """Half the bits, where the GPU has them."""
    if device == "cpu" or not torch.cuda.is_bf16_supported():
        return contextlib.nullcontext()
    return torch.autocast("cuda", dtype=torch.bfloat16)


def schedule(part):
    """Rises over a tenth of the steps, then falls as a cosine."""
    return part / 0.1 if part < 0.1 else 0.5 * (1 + math.cos(math.pi * (part - 0.1) / 0.9))


def drawn(sources, batch, random, device):
    each = [batch // len(sources)] * len(sources)
    each[0] += batch - sum(each)
    at = [
        torch.randint(len(x), (n,), generator=random, device=device)
        for n, (x, _) in zip(each, sources)
    ]
    pictures = torch.cat([x[k] for k, (x, _) in zip(at, sources)])
    return pictures, torch.cat([y[k] for k, (_, y) in zip(at, sources)])


@torch.no_grad()
def masks_of(net, pictures, batch=16):
    """Where the network sees cracks at even odds: (n, h, w) bool, on the processor."""
    net.eval()
    found = [net(x.float() / 255)[:, 0] > 0 for x in pictures.split(batch)]
    return torch.cat(found).cpu().numpy()
